"""Files and connections: results, solutions, meshes, dictionaries, pickling, TCP/IP."""
