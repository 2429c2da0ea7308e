"""Glass, chrome and paint, drawn by rays: the shadow of a ball has the size of the cone of light that touches it."""

import numpy as np

import dalembert as db

lamp, radius, height = 3.0, 0.4, 1.0  # m: heights of lamp and ball above the floor

model = db.Model()
material = db.graphics.material
floor = db.graphics.CheckerBoard(
    point=[0, 0, 0], size=8, nTiles=8,
    color=[0.9, 0.9, 0.9, material.indexChrome], alternatingColor=[0.75, 0.75, 0.8, material.indexChrome],
)  # fmt: skip
model.create_ground("floor", graphics_data_list=[floor])
ball = db.graphics.Sphere(radius=radius, color=[0.8, 0.3, 0.1, material.indexPlastic], nTiles=64)
model.create_ground("ball", reference_position=[0, 0, height], graphics_data_list=[ball])
model.assemble()

settings, renderer = model.container.visualizationSettings, model.container.renderer
settings.view0.camera.useRaytracer = True
settings.openGL.light1.enable = False
settings.openGL.light0.position = [0, 0, lamp, 1]
settings.openGL.light0.shadow = 1
settings.openGL.light0.specular = settings.raytracer.maxReflectionDepth = 0

# a view from above with 100 pixels per meter: the edge of the shadow along the row through the middle
settings.view0.window.renderWindowSize = [400, 400]
renderer.SetModelView(zoom=2)
row = np.asarray(renderer.RedrawAndGetImage())[200].mean(axis=1)
seen = (200 - (np.argmin(np.diff(row[:200])) + 1)) / 100
cone = lamp * np.tan(np.arcsin(radius / (lamp - height)))
print(f"radius of the shadow: {seen:.3f} m, of the cone of light {cone:.3f} m")

others = [
    db.graphics.Sphere(point=[0.9, -1.2, 0.45], radius=0.45, color=material.glass, nTiles=64),
    db.graphics.Sphere(point=[0.3, 1.0, 0.7], radius=0.7, color=[0.8, 0.8, 0.85, material.indexMirror], nTiles=64),
    db.graphics.Brick(centerPoint=[1.9, 0.1, 0.5], size=[0.9, 0.7, 1], color=[0.2, 0.4, 0.9, material.indexShiny]),
    db.graphics.Cylinder(pAxis=[-1.5, 0.8, 0], vAxis=[0, 0, 1.3], radius=0.35, nTiles=48,
                      color=[0.2, 0.7, 0.3, material.indexMatt]),
]  # fmt: skip
model.create_ground("others", graphics_data_list=others)
model.assemble()
settings.view0.camera.perspective = 0.4
settings.openGL.light0.position = [2.5, -4, 6, 1]
settings.openGL.light0.specular = 0.5
settings.openGL.light0.lightRadius, settings.raytracer.lightRadiusVariations = 0.6, 8
settings.raytracer.maxReflectionDepth, settings.raytracer.maxTransparencyDepth = 2, 4
settings.raytracer.multiSampling = 2
settings.general.useGradientBackground = True
renderer.SetModelView(zoom=2, rotationVector=[-1.1, 0, 0], centerPoint=[0.2, 0, 0.5])
model.draw(file_name="glass_picture.png", window_size=[560, 400])
