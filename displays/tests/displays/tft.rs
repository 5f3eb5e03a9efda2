//! The bytes that mipidsi sends for the same pictures, and what controllers make of them.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    pixelcolor::{raw::RawU24, PixelColor, Rgb565, Rgb666, Rgb888, RgbColor},
};
use embedded_raster::{
    pixel::{Be, Lsb0, Rgb332, Rgb444},
    surface::{Packed12, Pages, Planes, Rows},
    Frame, Index1, Index2, Index4, Index8, Layout, Palette, PixelFormat, Rect,
};
use embedded_raster_displays::{
    tft::{Orientation, Panel, Upper666},
    to_target, Error, Spi, Tft, Tft444, Tft565, Tft666, Transfers,
};
use mipidsi::{
    interface::{InterfacePixelFormat, SpiInterface},
    models::{ILI9341Rgb565, ILI9341Rgb666, Model, GC9A01, ST7789},
    options::{ColorOrder, Rotation},
    Builder, Display, NoResetPin,
};
use twins::rng::Rng;

use crate::{
    controllers::{mipi, Memory},
    pictures,
    wire::{Idle, Line, Wire},
};

/// A display through its driver.
fn driver<M>(
    model: M,
    wire: &Wire,
    buffer: &'static mut [u8],
    panel: Panel,
    turned: Orientation,
) -> Display<SpiInterface<'static, Wire, Line>, M, NoResetPin>
where
    M: Model,
    M::ColorFormat: InterfacePixelFormat<u8>,
{
    let Panel { size, at, .. } = panel;
    let interface = SpiInterface::new(wire.clone(), Line(wire.clone()), buffer);
    let display = Builder::new(model, interface).display_size(size.0, size.1).display_offset(at.0, at.1);
    let display = display.orientation(orientation(turned)).init(&mut Idle).expect("a size that the memory has");
    wire.take();
    display
}

fn orientation(Orientation { quarter_turns, is_mirrored }: Orientation) -> mipidsi::options::Orientation {
    let turn = [Rotation::Deg0, Rotation::Deg90, Rotation::Deg180, Rotation::Deg270][usize::from(quarter_turns & 3)];
    let turned = mipidsi::options::Orientation::new().rotate(turn);
    mipidsi::options::Orientation { mirrored: is_mirrored, ..turned }
}

fn random_orientation(rng: &mut Rng) -> Orientation {
    Orientation { quarter_turns: rng.index(4) as u8, is_mirrored: rng.one_in(2) }
}

/// A panel that shows pictures of a size when it is turned so.
fn random_panel(rng: &mut Rng, memory: (u16, u16), size: (u16, u16), turned: Orientation) -> Panel {
    let size = if turned.quarter_turns.is_multiple_of(2) { size } else { (size.1, size.0) };
    let at = (rng.int(0, i32::from(memory.0 - size.0)) as u16, rng.int(0, i32::from(memory.1 - size.1)) as u16);
    Panel { memory, size, at }
}

/// Areas of frames in the display's format, byte by byte.
fn check<M, F>(model: impl Fn() -> M)
where
    M: Model,
    M::ColorFormat: InterfacePixelFormat<u8> + PixelColor,
    F: PixelFormat<Color = M::ColorFormat>,
{
    let mut rng = Rng::new(1501);
    for case in 0..150 {
        let (size, turned) = (pictures::sizes(&mut rng), random_orientation(&mut rng));
        let panel = random_panel(&mut rng, M::FRAMEBUFFER_SIZE, size, turned);
        let wire = Wire::default();
        let mut display = driver(model(), &wire, vec![0; 96].leak(), panel, turned);
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let tft = Tft::<Rows<F>>::of_panel(panel, turned);

        let mut memory = pictures::memory::<Rows<F>>(&mut rng, size);
        // Bits that belong to no channel are sent as they are; drivers send none.
        let clean = Frame::<_, Rows<F>>::with_stride(&mut memory.0[..], size.0, size.1, memory.1);
        let mut clean = clean.expect("the right size");
        let colors: Vec<_> = clean.colors(clean.window()).collect();
        let window = clean.window().into();
        clean.fill_contiguous(&window, colors).expect("a frame");
        let before = memory.0.clone();
        let frame = pictures::frame::<Rows<F>>(&memory, size);
        let areas = pictures::areas(&mut rng);
        to_target(&frame, areas.iter().copied(), |color| color, &mut display).expect("it works");
        let wanted = wire.take();
        spi.send(tft.frame(&frame, areas.iter().copied())).expect("it works");
        assert_eq!(wire.take(), wanted, "case {case}: {areas:?} of {size:?}");

        // A view, as a picture of its own.
        let area = pictures::part(&mut rng);
        let view = frame.view(area);
        let (panel, turned) = (Panel { size: panel.memory, at: (0, 0), ..panel }, Orientation::default());
        let mut display = driver(model(), &wire, vec![0; 96].leak(), panel, turned);
        let tft = Tft::<Rows<F>>::new();
        to_target(&view, [view.window()], |color| color, &mut display).expect("it works");
        let wanted = wire.take();
        spi.send(tft.frame(&view, [view.window()])).expect("it works");
        assert_eq!(wire.take(), wanted, "case {case}: a view of {area:?} of {size:?}");

        // The same by conversion, whatever the length of the line.
        let needed = F::BITS as usize / 8;
        let mut line = vec![0; rng.int(needed as i32, 200) as usize];
        let converted = tft.converted(&frame, areas.iter().copied(), |color| color, &mut line).expect("a pixel fits");
        spi.send(converted).expect("it works");
        let converted = wire.take();
        spi.send(tft.frame(&frame, areas.iter().copied())).expect("it works");
        assert_eq!(wire.take(), converted, "case {case}: converted by {} bytes", line.len());
        let copied = tft.copied(&frame, areas.iter().copied(), &mut line).expect("a pixel fits");
        spi.send(copied).expect("it works");
        assert_eq!(wire.take(), converted, "case {case}: copied by {} bytes", line.len());
        // Of rows that fit, as many as fit.
        let whole = frame.window().width() as usize * needed;
        let fit = line.len() / whole;
        if fit > 0 {
            let mut transfers = tft.copied(&frame, [frame.window()], &mut line).expect("a pixel fits");
            let mut count = 0;
            while transfers.next().is_some() {
                count += 1;
            }
            assert_eq!(count, 2 + usize::from(size.1).div_ceil(fit), "case {case}: few transfers");
        }
        assert_eq!(memory.0, before, "a frame is only read");
    }
}

#[test]
fn frames_are_sent_as_mipidsi_sends_them() {
    check::<_, Be<Rgb565>>(|| ST7789);
    check::<_, Be<Rgb565>>(|| ILI9341Rgb565);
    check::<_, Be<Rgb565>>(|| GC9A01);
    check::<_, Upper666>(|| ILI9341Rgb666);
}

/// Indices through a palette, byte by byte.
fn check_palette<M, F, I, const N: usize>(model: impl Fn() -> M)
where
    M: Model,
    M::ColorFormat: InterfacePixelFormat<u8> + RgbColor,
    F: PixelFormat<Color = M::ColorFormat>,
    I: PixelFormat,
{
    let mut rng = Rng::new(1502);
    for case in 0..150 {
        let size = pictures::sizes(&mut rng);
        let panel = Panel { memory: M::FRAMEBUFFER_SIZE, size: M::FRAMEBUFFER_SIZE, at: (0, 0) };
        let wire = Wire::default();
        let mut display = driver(model(), &wire, vec![0; 96].leak(), panel, Orientation::default());
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let palette =
            Palette::<F::Color, N>::new([(); N].map(|()| F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS)))));

        let memory = pictures::memory::<Rows<I>>(&mut rng, size);
        let whole = pictures::frame::<Rows<I>>(&memory, size);
        let frame = if rng.one_in(3) { whole.view(pictures::part(&mut rng)) } else { whole };
        let areas = pictures::areas(&mut rng);
        // An index that the palette does not have is its first colour.
        let color = |index: I::Color| palette.get(I::pack(index) as u8).unwrap_or(palette.colors()[0]);
        to_target(&frame, areas.iter().copied(), color, &mut display).expect("it works");
        let wanted = wire.take();
        let mut line = vec![0; rng.int(F::BITS as i32 / 8, 200) as usize];
        let through = Tft::<Rows<F>>::new().through(&frame, areas.iter().copied(), &palette, &mut line);
        spi.send(through.expect("a pixel fits")).expect("it works");
        assert_eq!(wire.take(), wanted, "case {case}: {areas:?} of {size:?} by {} bytes", line.len());
    }
}

#[test]
fn indices_are_sent_through_palettes() {
    check_palette::<_, Be<Rgb565>, Index1, 2>(|| ST7789);
    check_palette::<_, Be<Rgb565>, Index2, 4>(|| ST7789);
    check_palette::<_, Be<Rgb565>, Lsb0<Index2>, 3>(|| ST7789);
    check_palette::<_, Be<Rgb565>, Index4, 16>(|| ILI9341Rgb565);
    check_palette::<_, Be<Rgb565>, Lsb0<Index4>, 11>(|| GC9A01);
    check_palette::<_, Be<Rgb565>, Index8, 256>(|| ST7789);
    check_palette::<_, Be<Rgb565>, Rgb332, 200>(|| ST7789);
    check_palette::<_, Upper666, Index4, 16>(|| ILI9341Rgb666);
    check_palette::<_, Upper666, Lsb0<Index1>, 2>(|| ILI9341Rgb666);
}

/// Frames of any layout, converted.
#[test]
fn other_colours_are_converted() {
    fn check<K: Layout>(seed: u64, convert: impl Fn(K::Color) -> Rgb666) {
        let mut rng = Rng::new(seed);
        for case in 0..60 {
            let size = pictures::sizes(&mut rng);
            let panel = Panel { memory: (240, 320), size, at: (0, 0) };
            let wire = Wire::default();
            let mut display = driver(ILI9341Rgb666, &wire, vec![0; 96].leak(), panel, Orientation::default());
            let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
            let memory = pictures::memory::<K>(&mut rng, size);
            let frame = pictures::frame::<K>(&memory, size);
            let areas = pictures::areas(&mut rng);
            to_target(&frame, areas.iter().copied(), &convert, &mut display).expect("it works");
            let wanted = wire.take();
            let mut line = vec![0; rng.int(3, 200) as usize];
            let sent = Tft666::new().converted(&frame, areas.iter().copied(), &convert, &mut line);
            spi.send(sent.expect("a pixel fits")).expect("it works");
            assert_eq!(wire.take(), wanted, "case {case}: {areas:?} of {size:?} by {} bytes", line.len());
        }
    }
    check::<Rows<Rgb565>>(1, Rgb666::from);
    check::<Packed12>(2, |color| Rgb666::from(Rgb888::from(color)));
    check::<Planes<Index2>>(3, |color| Rgb666::from(Rgb888::from(color)));
    check::<Pages<Index1>>(4, |color| Rgb666::from(Rgb888::from(color)));
}

/// Pixels of areas that a controller has been sent, at the places where the display shows them.
fn seen<L: Layout>(frame: &Frame<&[u8], L>, areas: &[Rect], at: (u16, u16), bits: impl Fn(L::Color) -> u32) -> Memory {
    let mut memory = Memory::new();
    for &area in areas {
        let area = area.intersection(frame.window());
        for (y, x) in (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| (y, x))) {
            let color = frame.get((x, y)).expect("inside");
            memory.insert((x + i32::from(at.0), y + i32::from(at.1)), bits(color));
        }
    }
    memory
}

#[test]
fn controllers_show_the_pixels_of_each_format() {
    let mut rng = Rng::new(1503);
    for case in 0..300 {
        let (size, areas) = (pictures::sizes(&mut rng), pictures::areas(&mut rng));
        let at = (rng.int(0, 300) as u16, rng.int(0, 300) as u16);
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));

        let memory = pictures::memory::<Rows<Be<Rgb565>>>(&mut rng, size);
        let frame = pictures::frame(&memory, size);
        spi.send(Tft565::new().with_offset(at.0, at.1).frame(&frame, areas.iter().copied())).expect("it works");
        assert_eq!(mipi(&wire.take(), 16), seen(&frame, &areas, at, Rgb565::pack), "case {case}: 16 bits");

        let memory = pictures::memory::<Rows<Upper666>>(&mut rng, size);
        let frame = pictures::frame(&memory, size);
        spi.send(Tft666::new().with_offset(at.0, at.1).frame(&frame, areas.iter().copied())).expect("it works");
        let upper = |bits: u32| bits & 0x00fc_fcfc;
        let sent: Memory = mipi(&wire.take(), 24).into_iter().map(|(place, bits)| (place, upper(bits))).collect();
        let wanted =
            |color: Rgb666| u32::from(color.r()) << 18 | u32::from(color.g()) << 10 | u32::from(color.b()) << 2;
        assert_eq!(sent, seen(&frame, &areas, at, wanted), "case {case}: 18 bits");
        // Full colours lie the same way.
        let full = pictures::frame::<Rows<Be<Rgb888>>>(&memory, size);
        spi.send(Tft::<Rows<Be<Rgb888>>>::new().with_offset(at.0, at.1).frame(&full, areas.iter().copied()))
            .expect("it works");
        let full: Memory = mipi(&wire.take(), 24).into_iter().map(|(place, bits)| (place, upper(bits))).collect();
        assert_eq!(full, sent, "case {case}: 24 bits");

        // Pairs of pixels: what is sent beside an area are pixels of the frame.
        let memory = pictures::memory::<Packed12>(&mut rng, size);
        let frame = pictures::frame::<Packed12>(&memory, size);
        let tft = Tft444::new().with_offset(at.0, at.1);
        spi.send(tft.frame(&frame, areas.iter().copied()).expect("aligned")).expect("it works");
        let sent = mipi(&wire.take(), 12);
        let (wanted, all) = (seen(&frame, &areas, at, Rgb444::pack), seen(&frame, &[frame.window()], at, Rgb444::pack));
        assert!(wanted.iter().all(|(place, bits)| sent.get(place) == Some(bits)), "case {case}: 12 bits");
        assert!(sent.iter().all(|(place, bits)| all.get(place) == Some(bits)), "case {case}: 12 bits, nothing else");
        assert!(sent.len() <= wanted.len() + 2 * 20 * areas.len(), "case {case}: a column on either side");
        let mut line = vec![0; rng.int(3, 100) as usize];
        let converted = tft.converted(&frame, areas.iter().copied(), |color| color, &mut line).expect("a pair fits");
        spi.send(converted).expect("it works");
        assert_eq!(mipi(&wire.take(), 12), wanted, "case {case}: 12 bits, converted by {} bytes", line.len());
    }
}

#[test]
fn views_that_begin_inside_of_a_pair_are_refused() {
    let picture = Frame::<_, Packed12>::new(&[0; 6][..], 4, 1).expect("the right size");
    let odd = picture.view(Rect::new(1, 0, 4, 1));
    let error = Tft444::new().frame(&odd, [odd.window()]).err();
    assert_eq!(error, Some(Error::Misaligned { at: 1, unit: 2 }));
    assert_eq!(Tft444::new().pixels(&odd).err(), Some(Error::Misaligned { at: 1, unit: 2 }));
    let narrow = picture.view(Rect::new(0, 0, 3, 1));
    assert_eq!(Tft444::new().pixels(&narrow).err(), Some(Error::Misaligned { at: 3, unit: 2 }));
    let even = picture.view(Rect::new(2, 0, 4, 1));
    assert!(Tft444::new().frame(&even, [even.window()]).is_ok());
    // An empty one has no place.
    let empty = picture.view(Rect::new(9, 0, 12, 1));
    assert!(Tft444::new().frame(&empty, [empty.window()]).expect("nothing to send").next().is_none());
}

#[test]
fn a_line_holds_a_pixel() {
    let picture = Frame::<_, Rows<Index4>>::new(&[0; 4][..], 8, 1).expect("the right size");
    let palette = Palette::new([Rgb565::BLACK; 16]);
    let error = Tft565::new().through(&picture, [picture.window()], &palette, &mut [0]).err();
    assert_eq!(error, Some(Error::LineTooShort { needed: 2, given: 1 }));
    let error = Tft444::new().converted(&picture, [picture.window()], |_| Rgb444::default(), &mut [0; 2]).err();
    assert_eq!(error, Some(Error::LineTooShort { needed: 3, given: 2 }));
    assert_eq!(
        error.map(|error| error.to_string()).as_deref(),
        Some("memory for a line too small: 3 bytes needed, 2 given"),
    );
}

#[test]
fn displays_turn_as_mipidsi_turns_them() {
    for (quarter_turns, is_mirrored, is_bgr) in (0..4)
        .flat_map(|turns| [(turns, false, false), (turns, true, false), (turns, false, true), (turns, true, true)])
    {
        let turned = Orientation { quarter_turns, is_mirrored };
        let wire = Wire::default();
        let interface = SpiInterface::new(wire.clone(), Line(wire.clone()), vec![0; 96].leak());
        let order = if is_bgr { ColorOrder::Bgr } else { ColorOrder::Rgb };
        let mut display = Builder::new(ST7789, interface).color_order(order).init(&mut Idle).expect("it works");
        wire.take();
        display.set_orientation(orientation(turned)).expect("it works");
        let wanted = wire.take();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        spi.send(Tft565::new().orientation(turned, is_bgr)).expect("it works");
        assert_eq!(wire.take(), wanted, "{turned:?}");
    }
}

/// A driver that is there in any case lends its interface, and is used again afterwards.
#[test]
fn frames_go_through_the_interface_of_mipidsi() {
    use mipidsi::interface::Interface;
    let mut rng = Rng::new(1504);
    let size = (31, 17);
    let wire = Wire::default();
    let mut interface = SpiInterface::new(wire.clone(), Line(wire.clone()), vec![0; 96].leak());
    let memory = pictures::memory::<Rows<Be<Rgb565>>>(&mut rng, size);
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, size);
    let areas = [Rect::new(0, 0, 31, 17), Rect::new(3, 2, 9, 11)];
    let sent = Tft565::new().frame(&frame, areas).send(|transfer| match transfer.command {
        [command] => interface.send_command(*command, transfer.data),
        _ => interface.send_command(0x3c, transfer.data),
    });
    assert!(sent.is_ok());
    assert_eq!(mipi(&wire.take(), 16), seen(&frame, &areas, (0, 0), Rgb565::pack));
}

/// A parallel bus: each write strobe takes what the wires say.
#[derive(Clone)]
struct Parallel<W> {
    wire: Wire,
    value: std::rc::Rc<std::cell::Cell<W>>,
}

impl<W: Copy + Into<u16>> mipidsi::interface::OutputBus for Parallel<W>
where
    W: Eq,
{
    type Word = W;
    type Error = std::convert::Infallible;
    const KIND: mipidsi::interface::InterfaceKind = if size_of::<W>() == 1 {
        mipidsi::interface::InterfaceKind::Parallel8Bit
    } else {
        mipidsi::interface::InterfaceKind::Parallel16Bit
    };

    fn set_value(&mut self, value: W) -> Result<(), Self::Error> {
        self.value.set(value);
        Ok(())
    }
}

impl<W> embedded_hal::digital::ErrorType for Parallel<W> {
    type Error = std::convert::Infallible;
}

impl<W: Copy + Into<u16>> embedded_hal::digital::OutputPin for Parallel<W> {
    fn set_low(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Self::Error> {
        let word: u16 = self.value.get().into();
        self.wire.write(&word.to_be_bytes()[2 - size_of::<W>()..]).expect("it works");
        Ok(())
    }
}

/// Eight wires take the bytes of a serial bus, sixteen take pixels; parameters lie in the low half.
#[test]
fn frames_go_over_parallel_buses() {
    use mipidsi::interface::{Interface, ParallelInterface};
    let mut rng = Rng::new(1505);
    let (size, areas) = ((31, 17), [Rect::new(0, 0, 31, 17), Rect::new(3, 2, 9, 11)]);
    let memory = pictures::memory::<Rows<Be<Rgb565>>>(&mut rng, size);
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, size);
    let wire = Wire::default();
    Spi::new(wire.clone(), Line(wire.clone())).send(Tft565::new().frame(&frame, areas)).expect("it works");
    let serial = wire.take();

    let bus = Parallel::<u8> { wire: wire.clone(), value: std::rc::Rc::default() };
    let mut eight = ParallelInterface::new(bus.clone(), Line(wire.clone()), bus);
    let sent = Tft565::new().frame(&frame, areas).send(|transfer| match transfer.command {
        [command] => eight.send_command(*command, transfer.data),
        _ => eight.send_command(0x3c, transfer.data),
    });
    assert!(sent.is_ok());
    let bytes = wire.take();
    assert_eq!(mipi(&bytes, 16), mipi(&serial, 16));

    let bus = Parallel::<u16> { wire: wire.clone(), value: std::rc::Rc::default() };
    let mut sixteen = ParallelInterface::new(bus.clone(), Line(wire.clone()), bus);
    let sent = Tft565::new().frame(&frame, areas).send(|transfer| match transfer.command {
        [0x2c] | [] => {
            transfer.command.iter().try_for_each(|&command| sixteen.send_command(command, &[]))?;
            sixteen.send_pixels(transfer.data.chunks_exact(2).map(|pixel| [u16::from_be_bytes([pixel[0], pixel[1]])]))
        }
        [command, ..] => sixteen.send_command(*command, transfer.data),
    });
    assert!(sent.is_ok());
    // Two bytes for each word: of commands and parameters the low one counts.
    let (mut bytes, mut is_pixels) = (vec![], false);
    for pair in wire.take().chunks(2) {
        let &[(is_data, high), (_, low)] = pair else { panic!("words") };
        if !is_data {
            is_pixels = low == 0x2c;
        } else if is_pixels {
            bytes.push((true, high));
        }
        bytes.push((is_data, low));
    }
    assert_eq!(bytes, serial);
}

/// The format is exact both ways.
#[test]
fn rgb666_is_itself_in_the_upper_bits() {
    for bits in 0..1 << 18 {
        let color = Rgb666::from(RawU24::new(bits));
        let packed = Upper666::pack(color);
        assert_eq!(Upper666::unpack(packed), color, "{bits:x}");
        assert_eq!(packed.to_le_bytes()[..3], [color.r() << 2, color.g() << 2, color.b() << 2], "{bits:x}");
    }
}
