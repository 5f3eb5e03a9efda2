//! A bus that records what is sent, and may fail.

use std::{cell::RefCell, convert::Infallible, rc::Rc};

use embedded_hal::{delay::DelayNs, digital, i2c, spi};

/// What the wires have seen.
#[derive(Debug, Default)]
struct Log {
    /// Bytes, each with the level of the data/command line.
    bytes: Vec<(bool, u8)>,
    /// Where transactions end in them: the chip select goes up.
    ends: Vec<usize>,
    is_data: bool,
    /// While a transaction is on its way: the level of the data/command line.
    in_flight: Option<bool>,
    /// Writes until one fails; those of pins count as well.
    until_failure: Option<usize>,
}

/// Two ends of a recorded bus: a device, a pin, a delay, as drivers want them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wire(Rc<RefCell<Log>>);

/// What happens when the bus fails.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Broken;

impl Wire {
    /// What was sent since the last call.
    pub(crate) fn take(&self) -> Vec<(bool, u8)> {
        let mut log = self.0.borrow_mut();
        log.ends.clear();
        std::mem::take(&mut log.bytes)
    }

    /// The bytes of each transaction since the last call, those left out that sent nothing.
    pub(crate) fn packets(&self) -> Vec<Vec<u8>> {
        let ends = std::mem::take(&mut self.0.borrow_mut().ends);
        let bytes = self.take();
        let starts = [0].into_iter().chain(ends.iter().copied());
        let packets = starts.zip(&ends).filter(|(start, end)| start < *end);
        packets.map(|(start, &end)| bytes[start..end].iter().map(|&(_, byte)| byte).collect()).collect()
    }

    /// All works until so many writes have been made.
    pub(crate) fn break_after(&self, writes: usize) {
        self.0.borrow_mut().until_failure = Some(writes);
    }

    fn step(&self) -> Result<(), Broken> {
        match &mut self.0.borrow_mut().until_failure {
            Some(0) => Err(Broken),
            Some(left) => {
                *left -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }

    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), Broken> {
        self.step()?;
        let mut log = self.0.borrow_mut();
        let is_data = log.is_data;
        log.bytes.extend(bytes.iter().map(|&byte| (is_data, byte)));
        Ok(())
    }

    /// Whether data are on their way, or a command, or nothing.
    pub(crate) fn in_flight(&self) -> Option<bool> {
        self.0.borrow().in_flight
    }

    fn set_in_flight(&self, is_in_flight: bool) {
        let mut log = self.0.borrow_mut();
        log.in_flight = is_in_flight.then_some(log.is_data);
    }

    fn end(&self) {
        let mut log = self.0.borrow_mut();
        let end = log.bytes.len();
        log.ends.push(end);
    }

    fn set(&self, is_data: bool) -> Result<(), Broken> {
        self.step()?;
        self.0.borrow_mut().is_data = is_data;
        Ok(())
    }
}

impl spi::Error for Broken {
    fn kind(&self) -> spi::ErrorKind {
        spi::ErrorKind::Other
    }
}

impl digital::Error for Broken {
    fn kind(&self) -> digital::ErrorKind {
        digital::ErrorKind::Other
    }
}

impl i2c::Error for Broken {
    fn kind(&self) -> i2c::ErrorKind {
        i2c::ErrorKind::Bus
    }
}

impl spi::ErrorType for Wire {
    type Error = Broken;
}

impl spi::SpiDevice for Wire {
    fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Broken> {
        for operation in operations {
            if let spi::Operation::Write(bytes) = operation {
                Wire::write(self, bytes)?;
            }
        }
        self.end();
        Ok(())
    }
}

/// Each transaction is not ready twice before it ends.
impl embedded_hal_async::spi::SpiDevice for Wire {
    async fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Broken> {
        spi::SpiDevice::transaction(self, operations)?;
        self.set_in_flight(true);
        busy().await;
        self.set_in_flight(false);
        Ok(())
    }
}

/// Is not ready when it is polled first, nor second.
pub(crate) async fn busy() {
    let mut polls = 0;
    std::future::poll_fn(|_| {
        polls += 1;
        if polls > 2 {
            std::task::Poll::Ready(())
        } else {
            std::task::Poll::Pending
        }
    })
    .await;
}

/// A bus without a chip select of its own.
impl spi::SpiBus for Wire {
    fn read(&mut self, _: &mut [u8]) -> Result<(), Broken> {
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Broken> {
        Wire::write(self, bytes)
    }

    fn transfer(&mut self, _: &mut [u8], bytes: &[u8]) -> Result<(), Broken> {
        Wire::write(self, bytes)
    }

    fn transfer_in_place(&mut self, bytes: &mut [u8]) -> Result<(), Broken> {
        Wire::write(self, bytes)
    }

    fn flush(&mut self) -> Result<(), Broken> {
        Ok(())
    }
}

impl i2c::ErrorType for Wire {
    type Error = Broken;
}

/// Control bytes become levels of the data/command line.
impl i2c::I2c for Wire {
    fn transaction(&mut self, address: u8, operations: &mut [i2c::Operation<'_>]) -> Result<(), Broken> {
        assert_eq!(address, 0x3c, "the display's address");
        let all: Vec<u8> = operations
            .iter()
            .flat_map(|operation| match operation {
                i2c::Operation::Write(bytes) => bytes.to_vec(),
                i2c::Operation::Read(_) => vec![],
            })
            .collect();
        let (control, bytes) = all.split_first().expect("a control byte");
        assert!([0x00, 0x40].contains(control), "a control byte");
        self.set(*control == 0x40)?;
        Wire::write(self, bytes)?;
        self.end();
        Ok(())
    }
}

impl embedded_hal_async::i2c::I2c for Wire {
    async fn transaction(&mut self, address: u8, operations: &mut [i2c::Operation<'_>]) -> Result<(), Broken> {
        i2c::I2c::transaction(self, address, operations)?;
        busy().await;
        Ok(())
    }
}

/// The data/command line of a wire.
#[derive(Clone, Debug)]
pub(crate) struct Line(pub(crate) Wire);

impl digital::ErrorType for Line {
    type Error = Broken;
}

impl digital::OutputPin for Line {
    fn set_low(&mut self) -> Result<(), Broken> {
        self.0.set(false)
    }

    fn set_high(&mut self) -> Result<(), Broken> {
        self.0.set(true)
    }
}

/// The chip select of a wire, high while the display is selected.
#[derive(Clone, Debug)]
pub(crate) struct Select(pub(crate) Wire);

impl digital::ErrorType for Select {
    type Error = Infallible;
}

impl digital::OutputPin for Select {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.end();
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Pins that nothing is connected to, a line that is never busy, and no time.
#[derive(Clone, Debug)]
pub(crate) struct Idle;

impl digital::ErrorType for Idle {
    type Error = Infallible;
}

impl digital::OutputPin for Idle {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Not busy, whichever level that is: some drivers ask for one, some for the other.
#[derive(Clone, Debug)]
pub(crate) struct NotBusy {
    pub(crate) is_low_busy: bool,
}

impl digital::ErrorType for NotBusy {
    type Error = Infallible;
}

impl digital::InputPin for NotBusy {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(self.is_low_busy)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(!self.is_low_busy)
    }
}

impl DelayNs for Idle {
    fn delay_ns(&mut self, _: u32) {}
}

/// As embedded-hal 0.2 has it: sh1106 speaks it.
impl embedded_hal_02::blocking::spi::Write<u8> for Wire {
    type Error = Broken;

    fn write(&mut self, bytes: &[u8]) -> Result<(), Broken> {
        Wire::write(self, bytes)
    }
}

impl embedded_hal_02::blocking::spi::Transfer<u8> for Wire {
    type Error = Broken;

    fn transfer<'w>(&mut self, bytes: &'w mut [u8]) -> Result<&'w [u8], Broken> {
        Wire::write(self, bytes)?;
        Ok(bytes)
    }
}

impl embedded_hal_02::digital::v2::OutputPin for Line {
    type Error = Broken;

    fn set_low(&mut self) -> Result<(), Broken> {
        self.0.set(false)
    }

    fn set_high(&mut self) -> Result<(), Broken> {
        self.0.set(true)
    }
}

/// A chip select that goes up at the end of a transaction.
#[derive(Clone, Debug)]
pub(crate) struct Select02(pub(crate) Wire);

impl embedded_hal_02::digital::v2::OutputPin for Select02 {
    type Error = Broken;

    fn set_low(&mut self) -> Result<(), Broken> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Broken> {
        self.0.end();
        Ok(())
    }
}

/// Runs a future that becomes ready by being polled.
pub(crate) fn run<T>(future: impl std::future::Future<Output = T>) -> T {
    let mut future = std::pin::pin!(future);
    for _ in 0..1_000_000 {
        let mut context = std::task::Context::from_waker(std::task::Waker::noop());
        if let std::task::Poll::Ready(result) = future.as_mut().poll(&mut context) {
            return result;
        }
    }
    panic!("it does not end");
}
