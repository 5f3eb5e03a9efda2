//! Draws the frames of the scenes that move on this computer and prints the checksums, in the form of the programs on the chips. What is
//! sent goes to a controller as well, which must show the frame then.

#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../board/src/crc.rs"]
mod crc;

use std::cell::RefCell;
use std::convert::Infallible;

use embedded_hal::digital::{self, OutputPin};
use embedded_hal::spi::{self, Operation, SpiDevice};
use embedded_raster_displays::Spi;
use scene::moving::{Failed, Moving, Plasma, Scope, FRAMES, LINE, PLASMA_BYTES, SCOPE_BYTES};
use scene::wire::Wire;
use scene::{HEIGHT, WIDTH};

/// A controller of the ST7789's kind: a window of columns and rows, and the pixels that fill it.
struct Controller {
    memory: Vec<u8>,
    is_data: bool,
    command: u8,
    parameters: Vec<u8>,
    /// First and last columns and rows.
    window: [[u16; 2]; 2],
    /// Bytes that were written since the window was opened.
    written: usize,
}

impl Controller {
    fn write(&mut self, byte: u8) {
        if !self.is_data {
            (self.command, self.written) = (byte, 0);
            return self.parameters.clear();
        }
        let axis = match self.command {
            0x2a => 0,
            0x2b => 1,
            _ => return self.write_pixel(byte),
        };
        self.parameters.push(byte);
        if let &[a, b, c, d] = &self.parameters[..] {
            self.window[axis] = [u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d])];
        }
    }

    fn write_pixel(&mut self, byte: u8) {
        assert_eq!(self.command, 0x2c, "a command that sends pixels");
        let [[x0, x1], [y0, _]] = self.window;
        let width = usize::from(x1 - x0) + 1;
        let (pixel, half) = (self.written / 2, self.written % 2);
        let (x, y) = (usize::from(x0) + pixel % width, usize::from(y0) + pixel / width);
        self.memory[y * LINE + 2 * x + half] = byte;
        self.written += 1;
    }
}

/// The device, or the pin.
#[derive(Copy, Clone)]
struct End<'a>(&'a RefCell<Controller>);

impl spi::ErrorType for End<'_> {
    type Error = Infallible;
}

impl SpiDevice for End<'_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            if let Operation::Write(bytes) = operation {
                bytes.iter().for_each(|&byte| self.0.borrow_mut().write(byte));
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
        self.0.borrow_mut().is_data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = true;
        Ok(())
    }
}

fn run(name: &str, mut scene: impl Moving) -> Result<(), Failed> {
    let memory = vec![0; LINE * usize::from(HEIGHT)];
    let window = [[0, WIDTH - 1], [0, HEIGHT - 1]];
    let controller =
        RefCell::new(Controller { memory, is_data: false, command: 0, parameters: vec![], window, written: 0 });
    for frame in 0..FRAMES {
        scene.draw()?;
        let wire = Wire::new(crc::crc32_with);
        scene.send(&mut wire.spi())?;
        scene.send(&mut Spi::new(End(&controller), End(&controller)))?;
        let (mut crc32, mut shown) = (0, vec![]);
        scene.whole(|row| {
            crc32 = crc::crc32_with(crc32, row);
            shown.extend_from_slice(row);
        });
        assert!(controller.borrow().memory == shown, "{name}: the display does not show frame {frame}");
        println!("{name}-{frame};{};-;0.0;0;{crc32:08x}", scene.format());
        println!("{name}-wire-{frame};{};-;0.0;0;{:08x}", scene.format(), wire.sum());
    }
    Ok(())
}

fn main() {
    let (mut pixels, mut line) = (vec![0; PLASMA_BYTES], vec![0; LINE]);
    let plasma = Plasma::new(&mut pixels, &mut line).and_then(|plasma| run("plasma", plasma));
    let mut buffers = [vec![0; SCOPE_BYTES], vec![0; SCOPE_BYTES]];
    let [first, second] = &mut buffers;
    let scope = run("scope", Scope::new([first, second], &mut line));
    assert_eq!((plasma, scope), (Ok(()), Ok(())), "memory for everything");
}
