"""First floor: shared memory whose readers never wait; under the state-variable table and the device bus."""
