//! A session with an original Dobot Arm over a serial port, TCP or in this process.
