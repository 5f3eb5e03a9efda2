//! The packets that ls013b7dh03 sends for the same pictures, and what the display makes of them.

use embedded_graphics_core::pixelcolor::BinaryColor;
use embedded_hal::digital::OutputPin;
use embedded_raster::{pixel::Lsb0, surface::Rows, Frame, Index1, PixelFormat, Rect};
use embedded_raster_displays::{memory_lcd, to_target, ActiveHigh, Error, NoPin, Spi, Transfers};
use ls013b7dh03::{Ls013b7dh03, BUF_SIZE};
use twins::rng::Rng;

use crate::{
    controllers::{self, Memory},
    pictures,
    wire::{Idle, Select, Wire},
};

#[test]
fn lines_are_sent_as_ls013b7dh03_sends_them() {
    let mut rng = Rng::new(1520);
    let wire = Wire::default();
    let mut memory = Box::new([0; BUF_SIZE]);
    let mut display = Ls013b7dh03::new(wire.clone(), Select(wire.clone()), Idle, &mut memory);
    let cleared = wire.packets();
    let mut spi = Spi::new(wire.clone(), NoPin);
    spi.send(memory_lcd::clear(false)).expect("it works");
    assert_eq!(wire.packets(), cleared);

    let mut pixels = vec![0xff; 16 * 128];
    for case in 0..100 {
        // Each of these lines changes: the driver sends no others.
        let (first, count) = (rng.index(128), 1 + rng.index(20));
        let last = (first + count).min(128);
        for y in first..last {
            for byte in &mut pixels[y * 16..y * 16 + 16] {
                *byte ^= 1 << rng.index(8);
            }
        }
        let frame = Frame::<_, Rows<BinaryColor>>::new(&pixels[..], 128, 128).expect("the right size");
        let area = Rect::new(rng.int(0, 127), first as i32, 128, last as i32);
        // What is on is dark for this driver.
        to_target(&frame, [frame.window()], BinaryColor::invert, &mut display).expect("it works");
        display.flush();
        let mut wanted = wire.packets();
        assert_eq!(wanted.len(), 1, "one packet");
        // The bits of nothing are ones there.
        for nothing in wanted[0].iter_mut().skip(1).skip(17).step_by(18) {
            assert_eq!(std::mem::take(nothing), 0xff, "nothing");
        }
        assert_eq!(wanted[0].pop(), Some(0xff), "nothing");
        wanted[0].push(0);
        let mut packet = [0; 2 + 128 * 18];
        spi.send(memory_lcd::lines(&frame, [area], false, &mut packet).expect("it fits")).expect("it works");
        assert_eq!(wire.packets(), wanted, "case {case}: lines {first} to {last}");
    }
}

fn check<F: PixelFormat>(seed: u64) {
    let mut rng = Rng::new(seed);
    for case in 0..200 {
        let (size, areas) = (pictures::sizes(&mut rng), pictures::areas(&mut rng));
        let memory = pictures::memory::<Rows<F>>(&mut rng, size);
        let frame = pictures::frame::<Rows<F>>(&memory, size);
        let (width, line) = (i32::from(size.0), usize::from(size.0).div_ceil(8));
        let mut packet = vec![0xa5; line + 4 + rng.index(200)];
        let vcom = rng.one_in(2);
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), NoPin);
        let lines = memory_lcd::lines(&frame, areas.iter().copied(), vcom, &mut packet).expect("it fits");
        spi.send(lines).expect("it works");
        let packets = wire.packets();
        assert!(packets.iter().all(|packet| packet[0] == if vcom { 0xc0 } else { 0x80 }), "VCOM");
        let mut wanted = Memory::new();
        for area in areas.iter().map(|area| area.intersection(frame.window())).filter(|area| !area.is_empty()) {
            for (y, x) in (area.y0..area.y1).flat_map(|y| (0..width).map(move |x| (y, x))) {
                wanted.insert((x, y), F::pack(frame.get((x, y)).expect("inside")));
            }
        }
        assert_eq!(controllers::memory_lcd(&packets, size.0.into()), wanted, "case {case}: {areas:?} of {size:?}");
        // As few packets as fit.
        let fit = (packet.len() - 2) / (line + 2);
        let rows = areas.iter().map(|area| area.intersection(frame.window())).filter(|area| !area.is_empty());
        assert_eq!(
            packets.len(),
            rows.map(|area| (area.height() as usize).div_ceil(fit)).sum::<usize>(),
            "case {case}"
        );
    }
}

#[test]
fn displays_show_the_lines_of_damage() {
    check::<BinaryColor>(1521);
    check::<Lsb0<BinaryColor>>(1522);
    check::<Index1>(1523);
}

#[test]
fn views_of_whole_lines_are_sent_or_refused() {
    let pixels: Vec<u8> = (0..3 * 300).map(|n| (n * 7 % 251) as u8).collect();
    let frame = Frame::<_, Rows<Index1>>::new(&pixels[..], 24, 300).expect("the right size");
    let sent = |frame: &Frame<&[u8], Rows<Index1>>| {
        let (wire, mut packet) = (Wire::default(), [0; 7]);
        Spi::new(wire.clone(), NoPin)
            .send(memory_lcd::lines(frame, [frame.window()], true, &mut packet)?)
            .expect("it works");
        Ok::<_, Error>(wire.packets())
    };
    // The last line that has a number.
    let packets = sent(&frame).expect("aligned");
    assert_eq!(packets.len(), 255);
    assert_eq!(packets[254], [0xc0, 0xff, pixels[762], pixels[763], pixels[764], 0, 0]);
    // Whole lines all the same.
    let clipped = frame.clipped(Rect::new(9, 1, 10, 2));
    assert_eq!(sent(&clipped), Ok(vec![vec![0xc0, 0x40, pixels[3], pixels[4], pixels[5], 0, 0]]));
    let view = frame.view(Rect::new(8, 5, 24, 6));
    assert_eq!(sent(&view), Ok(vec![vec![0xc0, 0x80, pixels[16], pixels[17], 0, 0]]));
    let inside = frame.view(Rect::new(9, 5, 24, 6));
    assert_eq!(sent(&inside), Err(Error::Misaligned { at: 9, unit: 8 }));
    let error = memory_lcd::lines(&frame, [], true, &mut [0; 6]).err();
    assert_eq!(error, Some(Error::LineTooShort { needed: 7, given: 6 }));
}

#[test]
fn vcom_is_held_and_the_display_cleared() {
    assert_eq!(memory_lcd::hold(true).next().map(|transfer| transfer.data.to_vec()), Some(vec![0x40, 0]));
    assert_eq!(memory_lcd::hold(false).next().map(|transfer| transfer.data.to_vec()), Some(vec![0, 0]));
    let mut clear = memory_lcd::clear(false);
    assert_eq!(clear.next().map(|transfer| transfer.data.to_vec()), Some(vec![0x20, 0]));
    assert!(clear.next().is_none());
}

#[test]
fn a_chip_select_is_turned_over() {
    let wire = Wire::default();
    let mut select = ActiveHigh(Select(wire.clone()));
    wire.write(&[1]).expect("it works");
    // Selected: high. Then low, which ends the transaction.
    select.set_low().expect("it works");
    wire.write(&[2]).expect("it works");
    select.set_high().expect("it works");
    assert_eq!(wire.packets(), [[1, 2]]);
}
