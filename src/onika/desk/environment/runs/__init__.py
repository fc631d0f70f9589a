"""Acts on runs of applications: judged, begun, steered, continued, kept."""
