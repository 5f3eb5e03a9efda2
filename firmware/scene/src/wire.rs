//! A bus that keeps a checksum of what it is sent, and nothing else: chips and computers must send the same.

use core::cell::Cell;
use core::convert::Infallible;

use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};
use embedded_raster_displays::Spi;

/// The wires of a display: bytes, and the line that tells data from commands.
pub struct Wire {
    sum: Cell<u32>,
    is_data: Cell<bool>,
    add: fn(u32, &[u8]) -> u32,
}

impl Wire {
    /// Nothing was sent. `add` goes on with a checksum.
    pub const fn new(add: fn(u32, &[u8]) -> u32) -> Self {
        Self { sum: Cell::new(0), is_data: Cell::new(false), add }
    }

    /// Where a display is sent something.
    pub fn spi(&self) -> Spi<End<'_>, End<'_>> {
        Spi::new(End(self), End(self))
    }

    /// The checksum of all that was sent: of each write a byte that is 1 for data and 0 for commands, and then its bytes.
    pub fn sum(&self) -> u32 {
        self.sum.get()
    }

    fn write(&self, bytes: &[u8]) {
        let sum = (self.add)(self.sum.get(), &[self.is_data.get().into()]);
        self.sum.set((self.add)(sum, bytes));
    }
}

/// One end of the wires: the device, or the pin.
#[derive(Copy, Clone)]
pub struct End<'a>(&'a Wire);

impl spi::ErrorType for End<'_> {
    type Error = Infallible;
}

impl SpiDevice for End<'_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            if let Operation::Write(bytes) = operation {
                self.0.write(bytes);
            }
        }
        Ok(())
    }
}

impl digital::ErrorType for End<'_> {
    type Error = Infallible;
}

impl OutputPin for End<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.is_data.set(false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.is_data.set(true);
        Ok(())
    }
}
