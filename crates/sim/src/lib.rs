//! Virtual Dobot Arms: in this process, on a virtual serial port and on TCP.
