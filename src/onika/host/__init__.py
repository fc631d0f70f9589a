"""The runtime program: supervisor, runner, request server, processing units, device server, loader."""
