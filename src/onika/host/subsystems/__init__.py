"""The subsystems of a runtime, held by hand or by an application, and what users want of them."""
