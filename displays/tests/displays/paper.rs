//! The bytes that epd-waveshare sends for the same pictures, and what controllers make of them.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    pixelcolor::{BinaryColor, Rgb888},
};
use embedded_raster::{
    pixel::EPAPER_7,
    surface::{Planes, Rows},
    Index1, Index2, Index4, PixelFormat, Rect,
};
use embedded_raster_displays::{
    paper::{self, Ram, Ssd16xx, Uc8176},
    to_target, Error, Spi,
};
use epd_waveshare::{
    color::{Color, OctColor, TriColor},
    epd2in13bc::{Display2in13bc, Epd2in13bc},
    epd2in9_v2::{Display2in9, Epd2in9},
    epd4in2::Epd4in2,
    epd5in65f::{Display5in65f, Epd5in65f},
    prelude::{WaveshareDisplay, WaveshareThreeColorDisplay},
};
use twins::rng::Rng;

use crate::{
    controllers::{ssd16xx, Memory},
    pictures,
    wire::{Idle, Line, NotBusy, Wire},
};

/// Without gaps between the rows, as drivers want all of a frame.
fn memory(rng: &mut Rng, bytes: usize) -> (Vec<u8>, usize) {
    ((0..bytes).map(|_| rng.bits() as u8).collect(), 0)
}

#[test]
fn black_and_white_is_sent_as_epd_waveshare_sends_it() {
    let mut rng = Rng::new(1530);
    let (mut wire, (pixels, _)) = (Wire::default(), memory(&mut rng, 128 / 8 * 296));
    let frame = embedded_raster::Frame::<_, Rows<BinaryColor>>::new(&pixels[..], 128, 296).expect("the right size");
    // The driver's own memory has the same bytes.
    let mut display = Display2in9::default();
    let color = |color: BinaryColor| if color.is_on() { Color::White } else { Color::Black };
    to_target(&frame, [frame.window()], color, &mut display).expect("it works");
    assert_eq!(frame.row_bytes(0..296), display.buffer());

    let line = Line(wire.clone());
    let mut driver =
        Epd2in9::new(&mut wire, NotBusy { is_low_busy: false }, line.clone(), Idle, &mut Idle, None).expect("it works");
    wire.take();
    driver.update_frame(&mut wire, frame.row_bytes(0..296), &mut Idle).expect("it works");
    let wanted = wire.take();
    let mut spi = Spi::new(wire.clone(), line);
    spi.send(paper::whole(&[0x24], &frame).expect("aligned")).expect("it works");
    assert_eq!(wire.take(), wanted);
}

#[test]
fn two_planes_are_sent_as_epd_waveshare_sends_them() {
    let mut rng = Rng::new(1531);
    // No pixel has both bits: for the driver there are three colours.
    let mut wire = Wire::default();
    let (mut pixels, _) = memory(&mut rng, 2 * 104 / 8 * 212);
    let (first, second) = pixels.split_at_mut(104 / 8 * 212);
    second.iter_mut().zip(first).for_each(|(red, white)| *red &= !*white);
    let frame = embedded_raster::Frame::<_, Planes<Index2>>::new(&pixels[..], 104, 212).expect("the right size");
    let mut display = Display2in13bc::default();
    let color = |color: Index2| match color {
        paper::BLACK => TriColor::Black,
        paper::WHITE => TriColor::White,
        paper::RED => TriColor::Chromatic,
        _ => panic!("three colours"),
    };
    to_target(&frame, [frame.window()], color, &mut display).expect("it works");
    assert_eq!([frame.plane_bytes(0), frame.plane_bytes(1)], [display.bw_buffer(), display.chromatic_buffer()]);

    let line = Line(wire.clone());
    let mut driver = Epd2in13bc::new(&mut wire, NotBusy { is_low_busy: true }, line.clone(), Idle, &mut Idle, None)
        .expect("it works");
    wire.take();
    driver.update_color_frame(&mut wire, &mut Idle, display.bw_buffer(), display.chromatic_buffer()).expect("it works");
    let wanted = wire.take();
    let mut spi = Spi::new(wire.clone(), line);
    spi.send(paper::planes([&[0x10], &[0x13]], &frame).expect("aligned")).expect("it works");
    assert_eq!(wire.take(), wanted);
}

#[test]
fn seven_colours_are_sent_as_epd_waveshare_sends_them() {
    let mut rng = Rng::new(1532);
    let mut wire = Wire::default();
    let pixels: Vec<u8> = (0..600 / 2 * 448).map(|_| rng.bits() as u8 & 0x77).collect();
    let frame = embedded_raster::Frame::<_, Rows<Index4>>::new(&pixels[..], 600, 448).expect("the right size");
    let mut display = Box::new(Display5in65f::default());
    let color = |color: Index4| OctColor::from_nibble(color.index()).expect("seven colours");
    to_target(&frame, [frame.window()], color, &mut *display).expect("it works");
    assert_eq!(frame.row_bytes(0..448), display.buffer());

    let line = Line(wire.clone());
    let mut driver = Epd5in65f::new(&mut wire, NotBusy { is_low_busy: true }, line.clone(), Idle, &mut Idle, None)
        .expect("it works");
    wire.take();
    driver.update_frame(&mut wire, display.buffer(), &mut Idle).expect("it works");
    let all = wire.take();
    let mut spi = Spi::new(wire.clone(), line);
    spi.send(paper::whole(&[0x10], &frame).expect("aligned")).expect("it works");
    let sent = wire.take();
    // The driver sets the border and the size each time.
    assert!(all.ends_with(&sent), "the same from 0x10 on");
    assert!(all.len() < sent.len() + 20, "and not much before it");
}

#[test]
fn the_palette_of_seven_colours_is_that_of_epd_waveshare() {
    for index in 0..7 {
        let wanted = Rgb888::from(OctColor::from_nibble(index).expect("a colour"));
        assert_eq!(EPAPER_7.get(index), Some(wanted), "{index}");
    }
    // What clears the paper is no ink: no colour is nearest to it, as greys would be to the grey that drivers have there.
    let levels = || (0..=255).step_by(15);
    for color in levels().flat_map(|r| levels().flat_map(move |g| levels().map(move |b| Rgb888::new(r, g, b)))) {
        assert_ne!(EPAPER_7.nearest(color), 7, "{color:?}");
    }
}

/// The pixels of some areas, grown to whole bytes: those of places that a frame has.
fn seen(size: (u16, u16), areas: &[Rect], get: impl Fn(i32, i32) -> Option<u32>) -> Memory {
    let mut memory = Memory::new();
    for &area in areas {
        let area = area.intersection(Rect::new(0, 0, size.0.into(), size.1.into()));
        if area.is_empty() {
            continue;
        }
        for (y, x) in (area.y0..area.y1).flat_map(|y| (area.x0 & !7..(area.x1 + 7) & !7).map(move |x| (y, x))) {
            if let Some(bit) = get(x, y) {
                memory.insert((x, y), bit);
            }
        }
    }
    memory
}

#[test]
fn controllers_show_what_is_damaged() {
    let mut rng = Rng::new(1533);
    for case in 0..300 {
        let (size, areas) = (pictures::sizes(&mut rng), pictures::areas(&mut rng));
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let is_inside = |memory: &Memory| -> Memory {
            memory.iter().filter(|((x, _), _)| *x < i32::from(size.0)).map(|(&place, &bit)| (place, bit)).collect()
        };

        let memory = pictures::memory::<Rows<Index1>>(&mut rng, size);
        let frame = pictures::frame::<Rows<Index1>>(&memory, size);
        let wanted = seen(size, &areas, |x, y| frame.get((x, y)).map(Index1::pack));
        for (number, ram) in [Ram::First, Ram::Second].into_iter().enumerate() {
            spi.send(Ssd16xx.frame(&frame, areas.iter().copied(), ram).expect("aligned")).expect("it works");
            let mut memories = ssd16xx(&wire.take());
            assert_eq!(is_inside(&memories[number]), wanted, "case {case}: {areas:?} of {size:?}");
            memories[number].clear();
            assert!(memories.iter().all(Memory::is_empty), "the other one is as it was");
        }

        let memory = pictures::memory::<Planes<Index2>>(&mut rng, size);
        let frame = pictures::frame::<Planes<Index2>>(&memory, size);
        spi.send(Ssd16xx.planes(&frame, areas.iter().copied()).expect("aligned")).expect("it works");
        for (number, memory) in ssd16xx(&wire.take()).iter().enumerate() {
            let wanted = seen(size, &areas, |x, y| frame.get((x, y)).map(|color| Index2::pack(color) >> number & 1));
            assert_eq!(is_inside(memory), wanted, "case {case}: plane {number} of {areas:?} of {size:?}");
        }
    }
}

/// The same windows as those of the driver, which takes columns below 256 only.
#[test]
fn windows_are_sent_as_epd_waveshare_sends_them() {
    let mut rng = Rng::new(1536);
    let mut wire = Wire::default();
    let (pixels, _) = memory(&mut rng, 400 / 8 * 300);
    let frame = embedded_raster::Frame::<_, Rows<Index1>>::new(&pixels[..], 400, 300).expect("the right size");
    let line = Line(wire.clone());
    let mut driver =
        Epd4in2::new(&mut wire, NotBusy { is_low_busy: true }, line.clone(), Idle, &mut Idle, None).expect("it works");
    let mut spi = Spi::new(wire.clone(), line);
    for case in 0..200 {
        let (x, y) = (rng.int(0, 255), rng.int(0, 299));
        let area = Rect::new(x, y, rng.int(x + 1, 256), rng.int(y + 1, 300));
        let mut memory = vec![0; 400 / 8 * 300];
        let (bytes, grown) = paper::part(&frame, area, &mut memory).expect("it fits");
        let (x, y) = (grown.x0 as u32, grown.y0 as u32);
        wire.take();
        driver
            .update_partial_frame(&mut wire, &mut Idle, bytes, x, y, grown.width(), grown.height())
            .expect("it works");
        let wanted = wire.take();
        spi.send(Uc8176.frame(&frame, [area], Ram::First).expect("aligned")).expect("it works");
        assert_eq!(wire.take(), wanted, "case {case}: {area:?}");
    }
    // Beyond them, and the other memory.
    spi.send(Uc8176.frame(&frame, [Rect::new(301, 290, 305, 291)], Ram::Second).expect("aligned")).expect("it works");
    let sent: Vec<u8> = wire.take().into_iter().map(|(_, byte)| byte).collect();
    let byte = pixels[290 * 50 + 37];
    let wanted =
        [&[0x91, 0x90][..], &[1, 0x28, 1, 0x37, 1, 0x22, 1, 0x22, 1], &[0x10, byte, pixels[290 * 50 + 38], 0x92]]
            .concat();
    assert_eq!(sent, wanted);
}

/// What a driver is handed for a part: rows without gaps.
#[test]
fn parts_are_rows_of_whole_bytes() {
    fn check<F: PixelFormat>(seed: u64) {
        let mut rng = Rng::new(seed);
        for case in 0..300 {
            let (size, area) = (pictures::sizes(&mut rng), pictures::area(&mut rng));
            let memory = pictures::memory::<Rows<F>>(&mut rng, size);
            let frame = pictures::frame::<Rows<F>>(&memory, size);
            let mut out = vec![0; 1000];
            let (bytes, grown) = paper::part(&frame, area, &mut out).expect("it fits");
            let inside = area.intersection(frame.window());
            if inside.is_empty() {
                assert!(bytes.is_empty(), "case {case}: nothing");
                continue;
            }
            assert_eq!(grown.union(inside), grown, "case {case}: it grows");
            let wanted: Vec<u8> = frame.bytes(inside).flatten().copied().collect();
            assert_eq!(bytes, wanted, "case {case}: {area:?} of {size:?}");
            let given = wanted.len() - 1;
            let error = paper::part(&frame, area, &mut out[..given]).err();
            assert_eq!(error, Some(Error::LineTooShort { needed: wanted.len(), given }), "case {case}");
        }
    }
    check::<Index1>(1534);
    check::<Index4>(1535);
}

/// A driver's display is a target like others.
#[test]
fn drivers_memory_can_be_drawn_on() {
    let mut display = Display2in9::default();
    display.clear(Color::White).expect("it works");
    assert!(display.buffer().iter().all(|&byte| byte == 0xff), "white");
}
