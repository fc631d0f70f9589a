"""Acts on configurations, their tasks and their libraries."""
