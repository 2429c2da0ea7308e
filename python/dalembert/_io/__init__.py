"""Files and connections: results, solutions, dictionaries, pickling, TCP/IP."""
