//! Nothing but start-up and exit: what the other firmwares are compared with.
#![no_std]
#![no_main]

board::entry!(main);

fn main() {}
