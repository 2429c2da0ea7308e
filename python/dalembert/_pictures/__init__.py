"""Pictures without a display: scenes of items, cameras, and what draws them. Public: SC.renderer, mbs.Draw."""
