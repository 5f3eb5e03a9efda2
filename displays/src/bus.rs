//! [`Spi`] and [`I2c`]: transfers over the buses of embedded-hal 1 and embedded-hal-async 1.

use core::{convert::Infallible, fmt};

use embedded_hal::{
    digital::{ErrorType, OutputPin},
    i2c,
    spi::SpiDevice,
};
use embedded_raster::BufferError;

use crate::transfer::{Transfer, Transfers};

/// The most bytes that are handed to a bus at once: DMA engines count in 16 bits, and pixels of 2, 3 and 4 bytes stay whole.
const LARGEST: usize = 65_532;

/// A display on a serial bus of four wires, with a line that tells data from commands.
///
/// Both `send` and `send_async` are there for devices that implement `SpiDevice` of embedded-hal, or of embedded-hal-async.
#[derive(Debug)]
pub struct Spi<D, P> {
    device: D,
    /// Low for commands, high for data.
    data_command: P,
}

/// What went wrong on the way.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BusError<B, P = Infallible> {
    /// The bus.
    Bus(B),
    /// The line that tells data from commands.
    Pin(P),
    /// The bands of a frame could not be made: functions that draw and send them have one type for all their errors.
    Buffer(BufferError),
}

impl<B: fmt::Debug, P: fmt::Debug> fmt::Display for BusError<B, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bus(error) => write!(f, "the bus of the display failed: {error:?}"),
            Self::Pin(error) => write!(f, "the data/command line of the display failed: {error:?}"),
            Self::Buffer(error) => error.fmt(f),
        }
    }
}

impl<B: fmt::Debug, P: fmt::Debug> core::error::Error for BusError<B, P> {}

impl<B, P> From<BufferError> for BusError<B, P> {
    fn from(error: BufferError) -> Self {
        Self::Buffer(error)
    }
}

impl<D, P> Spi<D, P> {
    /// A device with its chip select, and the data/command line.
    pub const fn new(device: D, data_command: P) -> Self {
        Self { device, data_command }
    }

    /// Gives both back: to a driver that turns the display off, say.
    pub fn release(self) -> (D, P) {
        (self.device, self.data_command)
    }
}

impl<D: SpiDevice, P: OutputPin> Spi<D, P> {
    /// Sends all transfers.
    ///
    /// # Errors
    /// The first one of the bus or of the pin. What was sent until then has arrived.
    pub fn send(&mut self, transfers: impl Transfers) -> Result<(), BusError<D::Error, P::Error>> {
        transfers.send(|Transfer { command, data }| {
            if !command.is_empty() {
                self.data_command.set_low().map_err(BusError::Pin)?;
                self.device.write(command).map_err(BusError::Bus)?;
            }
            if !data.is_empty() {
                self.data_command.set_high().map_err(BusError::Pin)?;
            }
            data.chunks(LARGEST).try_for_each(|data| self.device.write(data)).map_err(BusError::Bus)
        })
    }
}

impl<D: embedded_hal_async::spi::SpiDevice, P: OutputPin> Spi<D, P> {
    /// Sends all transfers, and awaits each.
    ///
    /// # Errors
    /// Those of [`send`](Self::send).
    pub async fn send_async(&mut self, transfers: impl Transfers) -> Result<(), BusError<D::Error, P::Error>> {
        transfers
            .send_async(async |Transfer { command, data }| {
                if !command.is_empty() {
                    self.data_command.set_low().map_err(BusError::Pin)?;
                    self.device.write(command).await.map_err(BusError::Bus)?;
                }
                if !data.is_empty() {
                    self.data_command.set_high().map_err(BusError::Pin)?;
                }
                for data in data.chunks(LARGEST) {
                    self.device.write(data).await.map_err(BusError::Bus)?;
                }
                Ok(())
            })
            .await
    }
}

/// A display on a bus of two wires, as most small OLEDs are. Each part of a transfer begins with a control byte: 0x00 before commands, 0x40
/// before data.
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use embedded_raster::surface::Paged;
/// use embedded_raster_displays::{I2c, Oled};
/// # use embedded_hal::i2c;
/// fn show<B: i2c::I2c>(bus: B, frame: &Paged<BinaryColor>) -> Result<(), Box<dyn core::error::Error>>
/// # where B::Error: 'static
/// {
///     let mut i2c = I2c::new(bus, 0x3c);
///     i2c.send(Oled::SSD1306.frame(frame, [frame.window()])?)?;
///     Ok(())
/// }
/// ```
#[derive(Debug)]
pub struct I2c<B> {
    bus: B,
    address: u8,
}

/// Before commands and before data: no other control byte follows.
const COMMANDS: [u8; 1] = [0x00];
const DATA: [u8; 1] = [0x40];

impl<B> I2c<B> {
    /// The display's address in 7 bits is 0x3c or 0x3d in most cases.
    pub const fn new(bus: B, address: u8) -> Self {
        Self { bus, address }
    }

    /// Gives the bus back.
    pub fn release(self) -> B {
        self.bus
    }
}

impl<B: i2c::I2c> I2c<B> {
    /// Sends all transfers.
    ///
    /// # Errors
    /// The first one of the bus. What was sent until then has arrived.
    pub fn send(&mut self, transfers: impl Transfers) -> Result<(), BusError<B::Error>> {
        transfers.send(|Transfer { command, data }| {
            for (control, bytes) in [(&COMMANDS, command), (&DATA, data)] {
                if !bytes.is_empty() {
                    let mut parts = [i2c::Operation::Write(control), i2c::Operation::Write(bytes)];
                    self.bus.transaction(self.address, &mut parts).map_err(BusError::Bus)?;
                }
            }
            Ok(())
        })
    }
}

impl<B: embedded_hal_async::i2c::I2c> I2c<B> {
    /// Sends all transfers, and awaits each.
    ///
    /// # Errors
    /// Those of [`send`](Self::send).
    pub async fn send_async(&mut self, transfers: impl Transfers) -> Result<(), BusError<B::Error>> {
        transfers
            .send_async(async |Transfer { command, data }| {
                for (control, bytes) in [(&COMMANDS, command), (&DATA, data)] {
                    if !bytes.is_empty() {
                        let mut parts = [i2c::Operation::Write(control), i2c::Operation::Write(bytes)];
                        self.bus.transaction(self.address, &mut parts).await.map_err(BusError::Bus)?;
                    }
                }
                Ok(())
            })
            .await
    }
}

/// For displays without a data/command line: nothing is connected.
#[derive(Copy, Clone, Debug, Default)]
pub struct NoPin;

impl ErrorType for NoPin {
    type Error = Infallible;
}

impl OutputPin for NoPin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// A chip select that is high while the display is selected, as Sharp's memory LCDs have it: a pin for those who expect it low.
#[derive(Copy, Clone, Debug)]
pub struct ActiveHigh<P>(pub P);

impl<P: ErrorType> ErrorType for ActiveHigh<P> {
    type Error = P::Error;
}

impl<P: OutputPin> OutputPin for ActiveHigh<P> {
    fn set_low(&mut self) -> Result<(), P::Error> {
        self.0.set_high()
    }

    fn set_high(&mut self) -> Result<(), P::Error> {
        self.0.set_low()
    }
}
