// A program without tests: what it precompiles serves all that have some.
