"""The live page: a server on this machine, and a viewer that follows the systems of a container."""
