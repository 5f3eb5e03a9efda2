//! The bytes that ssd1306 and sh1106 send for the same pictures, and what controllers make of them.

use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, pixelcolor::BinaryColor, Pixel};
use embedded_raster::{
    pixel::Lsb0,
    surface::{paged_bytes, Paged, Pages},
    Canvas, Frame, Index1, Rect,
};
use embedded_raster_displays::{Error, I2c, Oled, Spi, Transfer, Transfers};
use ssd1306::{prelude::*, Ssd1306};
use twins::rng::Rng;

use crate::{
    controllers::{pages, Memory},
    pictures,
    wire::{Line, Select02, Wire},
};

type Binary = Pages<Lsb0<BinaryColor>>;

fn on(is_on: bool) -> BinaryColor {
    BinaryColor::from(is_on)
}

/// A box of random pixels, on a frame and on a display.
fn scribble<D: DrawTarget<Color = BinaryColor>>(
    rng: &mut Rng,
    area: Rect,
    frame: &mut Paged<BinaryColor>,
    display: &mut D,
) where
    D::Error: std::fmt::Debug,
{
    for (x, y) in (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| (x, y))) {
        // Its corners are drawn in any case: the driver sends the box of what was drawn.
        let (p, color) = (Point::new(x, y), on(rng.one_in(2)));
        frame.draw_point(p, color);
        display.draw_iter([Pixel(p, color)]).expect("it works");
    }
}

fn area_of(rng: &mut Rng, width: i32, height: i32) -> Rect {
    let (x0, y0) = (rng.int(0, width - 1), rng.int(0, height - 1));
    Rect::new(x0, y0, rng.int(x0 + 1, width), rng.int(y0 + 1, height))
}

fn check_ssd1306<S: DisplaySize + Copy>(size: S, oled: Oled) {
    let mut rng = Rng::new(1510);
    let wire = Wire::default();
    let (width, height) = (S::WIDTH, S::HEIGHT);
    // The driver's interface: what it is sent is recorded as it is.
    let interface = Recorded(wire.clone());
    let mut display = Ssd1306::new(interface, size, DisplayRotation::Rotate0).into_buffered_graphics_mode();
    display.init().expect("it works");
    let mut memory = vec![0; paged_bytes(width.into(), height.into())];
    let mut frame = Paged::<BinaryColor>::new(&mut memory, width.into(), height.into()).expect("the right size");
    display.flush().expect("it works");
    wire.take();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    for case in 0..200 {
        let area = area_of(&mut rng, width.into(), height.into());
        scribble(&mut rng, area, &mut frame, &mut display);
        display.flush().expect("it works");
        let wanted = wire.take();
        spi.send(oled.frame(&frame, [area]).expect("aligned")).expect("it works");
        assert_eq!(wire.take(), wanted, "case {case}: {area:?} of {width} x {height}");
    }
}

/// `display-interface`, recorded.
struct Recorded(Wire);

impl display_interface::WriteOnlyDataCommand for Recorded {
    fn send_commands(
        &mut self,
        bytes: display_interface::DataFormat<'_>,
    ) -> Result<(), display_interface::DisplayError> {
        use embedded_hal::digital::OutputPin;
        Line(self.0.clone()).set_low().map_err(|_| display_interface::DisplayError::DCError)?;
        self.write(&bytes)
    }

    fn send_data(&mut self, bytes: display_interface::DataFormat<'_>) -> Result<(), display_interface::DisplayError> {
        use embedded_hal::digital::OutputPin;
        Line(self.0.clone()).set_high().map_err(|_| display_interface::DisplayError::DCError)?;
        self.write(&bytes)
    }
}

impl Recorded {
    fn write(&self, bytes: &display_interface::DataFormat<'_>) -> Result<(), display_interface::DisplayError> {
        let display_interface::DataFormat::U8(bytes) = bytes else { panic!("bytes") };
        self.0.write(bytes).map_err(|_| display_interface::DisplayError::BusWriteError)
    }
}

#[test]
fn frames_are_sent_as_ssd1306_sends_them() {
    check_ssd1306(DisplaySize128x64, Oled::SSD1306);
    check_ssd1306(DisplaySize128x32, Oled::SSD1306);
    check_ssd1306(DisplaySize96x16, Oled::SSD1306);
    check_ssd1306(DisplaySize72x40, Oled::SSD1306.with_offset(28, 0));
    check_ssd1306(DisplaySize64x48, Oled::SSD1306.with_offset(32, 0));
    check_ssd1306(DisplaySize64x32, Oled::SSD1306.with_offset(32, 0));
}

/// What the driver draws in its own memory is what a frame holds.
#[test]
fn frames_are_sent_as_sh1106_sends_them() {
    let mut rng = Rng::new(1511);
    for (size, oled) in [
        (sh1106::prelude::DisplaySize::Display128x64, Oled::SH1106),
        (sh1106::prelude::DisplaySize::Display128x64NoOffset, Oled::SH1107),
        (sh1106::prelude::DisplaySize::Display128x32, Oled::SH1106),
        (sh1106::prelude::DisplaySize::Display132x64, Oled::SH1107),
    ] {
        let wire = Wire::default();
        let builder = sh1106::Builder::new().with_size(size);
        let mut display: sh1106::mode::GraphicsMode<_> =
            builder.connect_spi(wire.clone(), Line(wire.clone()), Select02(wire.clone())).into();
        display.init().expect("it works");
        wire.take();
        let (width, height) = size.dimensions();
        let mut memory = vec![0; paged_bytes(width.into(), height.into())];
        let mut frame = Paged::<BinaryColor>::new(&mut memory, width.into(), height.into()).expect("the right size");
        for case in 0..10 {
            let area = area_of(&mut rng, width.into(), height.into());
            scribble(&mut rng, area, &mut frame, &mut display);
            display.flush().expect("it works");
            let mut wanted = wire.take();
            // After the last page the driver goes back to the first one, and sends nothing there.
            let back = wanted.split_off(wanted.len() - 3);
            assert!(back.iter().all(|&(is_data, _)| !is_data), "an address: {back:?}");

            // By the bus of embedded-hal 0.2 that this driver has.
            let whole = oled.frame(&frame, [frame.window()]).expect("aligned");
            whole
                .send(|Transfer { command, data }| {
                    use embedded_hal_02::{blocking::spi::Write, digital::v2::OutputPin};
                    let (mut bus, mut line) = (wire.clone(), Line(wire.clone()));
                    line.set_low()?;
                    Write::write(&mut bus, command)?;
                    line.set_high()?;
                    Write::write(&mut bus, data)
                })
                .expect("it works");
            assert_eq!(wire.take(), wanted, "case {case}: {width} x {height}");
        }
    }
}

/// Through the interface of sh1106 itself, which its users have.
#[test]
fn pages_go_through_the_interface_of_sh1106() {
    use sh1106::interface::DisplayInterface;
    let mut rng = Rng::new(1512);
    let wire = Wire::default();
    let mut interface = sh1106::interface::SpiInterface::new(wire.clone(), Line(wire.clone()), Select02(wire.clone()));
    let memory = pictures::memory::<Binary>(&mut rng, (128, 64));
    let frame = pictures::frame::<Binary>(&memory, (128, 64));
    let areas = [Rect::new(5, 3, 77, 31), Rect::new(0, 60, 128, 64)];
    let transfers = Oled::SH1106.frame(&frame, areas).expect("aligned");
    transfers
        .send(|Transfer { command, data }| {
            interface.send_commands(command)?;
            interface.send_data(data)
        })
        .expect("it works");
    let sent = pages(&wire.take());
    assert_eq!(sent, seen(&frame, &areas, (2, 0)));
}

/// What a display shows of pages that were sent.
fn seen(frame: &Frame<&[u8], Binary>, areas: &[Rect], at: (i32, i32)) -> Memory {
    let mut memory = Memory::new();
    for &area in areas {
        let area = area.intersection(frame.window());
        if area.is_empty() {
            continue;
        }
        for (y, x) in (area.y0 & !7..(area.y1 + 7) & !7).flat_map(|y| (area.x0..area.x1).map(move |x| (y, x))) {
            if let Some(color) = frame.get((x, y)) {
                memory.insert((x + at.0, y + at.1), u32::from(color.is_on()));
            }
        }
    }
    memory
}

#[test]
fn controllers_show_the_pages_of_damage() {
    let mut rng = Rng::new(1513);
    for case in 0..400 {
        let (size, areas) = (pictures::sizes(&mut rng), pictures::areas(&mut rng));
        let memory = pictures::memory::<Binary>(&mut rng, size);
        let before = memory.0.clone();
        let frame = pictures::frame::<Binary>(&memory, size);
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let mut i2c = I2c::new(wire.clone(), 0x3c);
        let (columns, first) = (rng.index(60) as u8, rng.index(3) as u8);
        for oled in [Oled::SSD1306, Oled::SH1106] {
            let oled = oled.with_offset(columns, first);
            spi.send(oled.frame(&frame, areas.iter().copied()).expect("aligned")).expect("it works");
            let bytes = wire.take();
            let wanted = seen(&frame, &areas, (columns.into(), 8 * i32::from(first)));
            let mut sent = pages(&bytes);
            // Below the last row, the last page has bits of nothing.
            sent.retain(|&(_, y), _| y < i32::from(size.1) + 8 * i32::from(first));
            assert_eq!(sent, wanted, "case {case}: {areas:?} of {size:?}");
            i2c.send(oled.frame(&frame, areas.iter().copied()).expect("aligned")).expect("it works");
            assert_eq!(wire.take(), bytes, "the same on two wires");
        }
        assert_eq!(memory.0, before, "a frame is only read");
    }
}

#[test]
fn views_lie_in_pages_or_are_refused() {
    let mut rng = Rng::new(1514);
    let memory = pictures::memory::<Pages<Lsb0<Index1>>>(&mut rng, (40, 24));
    let frame = pictures::frame::<Pages<Lsb0<Index1>>>(&memory, (40, 24));
    let inside = frame.view(Rect::new(7, 4, 20, 24));
    assert_eq!(Oled::SSD1306.frame(&inside, [inside.window()]).err(), Some(Error::Misaligned { at: 4, unit: 8 }),);
    let wire = Wire::default();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    let view = frame.view(Rect::new(7, 8, 20, 24));
    spi.send(Oled::SSD1306.frame(&view, [view.window()]).expect("aligned")).expect("it works");
    let sent = pages(&wire.take());
    for ((x, y), bit) in sent {
        assert_eq!(view.get((x, y)), Some(Index1::new(bit as u8)), "({x}, {y})");
    }
    // A part whose coordinates stay: pages lie where they did.
    let clipped = frame.clipped(Rect::new(7, 4, 20, 20));
    spi.send(Oled::SSD1306.frame(&clipped, [clipped.window()]).expect("aligned")).expect("it works");
    for ((x, y), bit) in pages(&wire.take()) {
        assert_eq!(frame.get((x, y)), Some(Index1::new(bit as u8)), "({x}, {y})");
    }
}

/// Controllers have 256 columns and 16 pages at most: what a frame has beyond them is not sent.
#[test]
fn what_no_controller_has_is_left_out() {
    let mut rng = Rng::new(1515);
    let memory = pictures::memory::<Binary>(&mut rng, (300, 150));
    let frame = pictures::frame::<Binary>(&memory, (300, 150));
    for (oled, (columns, first)) in [Oled::SSD1306, Oled::SH1107].into_iter().zip([(0, 0), (10, 3)]) {
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let oled = oled.with_offset(columns as u8, first as u8);
        spi.send(oled.frame(&frame, [frame.window()]).expect("aligned")).expect("it works");
        let inside = Rect::new(0, 0, 256 - columns, 8 * (16 - first));
        assert_eq!(pages(&wire.take()), seen(&frame, &[inside], (columns, 8 * first)), "{oled:?}");
    }
}

#[test]
fn displays_turn_as_ssd1306_turns_them() {
    for (rotation, is_upside_down) in [(DisplayRotation::Rotate0, false), (DisplayRotation::Rotate180, true)] {
        for is_mirrored in [false, true] {
            let wire = Wire::default();
            let mut display = Ssd1306::new(Recorded(wire.clone()), DisplaySize128x64, rotation);
            display.set_mirror(is_mirrored).expect("it works");
            let wanted = wire.take();
            let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
            spi.send(Oled::SSD1306.orientation(is_upside_down, is_mirrored)).expect("it works");
            assert_eq!(wire.take(), wanted, "{rotation:?}, mirrored: {is_mirrored}");
        }
    }
}
