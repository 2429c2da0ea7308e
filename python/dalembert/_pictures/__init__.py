"""Pictures without a display: scenes of items, cameras, and drawing. Public: SC.renderer, mbs.Draw."""
