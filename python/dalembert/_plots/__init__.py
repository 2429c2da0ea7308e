"""Pictures: curves of sensors, images, the graph of a system, tables in notebooks."""
