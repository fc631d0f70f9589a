"""The runtime program: supervisor, runner, gate, processing units, device server, loader."""
