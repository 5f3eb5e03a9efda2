//! Buses: blocking and not, errors, and long transfers.

use embedded_graphics_core::pixelcolor::{BinaryColor, Rgb565};
use embedded_raster::{
    pixel::{Be, Lsb0},
    surface::{Pages, Rows},
    BufferError, Rect,
};
use embedded_raster_displays::{BusError, I2c, Oled, Spi, Tft565, Transfers};
use twins::rng::Rng;

use crate::{
    pictures,
    wire::{run, Broken, Line, Wire},
};

const AREAS: [Rect; 3] = [Rect::new(1, 2, 9, 7), Rect::new(0, 0, 19, 3), Rect::new(5, 5, 6, 6)];

#[test]
fn what_is_awaited_is_the_same() {
    let mut rng = Rng::new(1580);
    let memory = pictures::memory::<Rows<Be<Rgb565>>>(&mut rng, (19, 11));
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, (19, 11));
    let wire = Wire::default();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    spi.send(Tft565::new().frame(&frame, AREAS)).expect("it works");
    let wanted = wire.take();
    run(spi.send_async(Tft565::new().frame(&frame, AREAS))).expect("it works");
    assert_eq!(wire.take(), wanted);

    let memory = pictures::memory::<Pages<Lsb0<BinaryColor>>>(&mut rng, (19, 11));
    let frame = pictures::frame::<Pages<Lsb0<BinaryColor>>>(&memory, (19, 11));
    let mut i2c = I2c::new(wire.clone(), 0x3c);
    i2c.send(Oled::SH1106.frame(&frame, AREAS).expect("aligned")).expect("it works");
    let wanted = wire.take();
    run(i2c.send_async(Oled::SH1106.frame(&frame, AREAS).expect("aligned"))).expect("it works");
    assert_eq!(wire.take(), wanted);
    let (_device, _line) = spi.release();
    let _bus = i2c.release();
}

/// After any number of writes the bus or the pin fails: the error comes back, what was sent is the beginning, and the frame can be sent again.
#[test]
fn errors_of_the_bus_are_passed_on() {
    let mut rng = Rng::new(1581);
    let memory = pictures::memory::<Rows<Be<Rgb565>>>(&mut rng, (19, 11));
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, (19, 11));
    let whole = {
        let wire = Wire::default();
        Spi::new(wire.clone(), Line(wire.clone())).send(Tft565::new().frame(&frame, AREAS)).expect("it works");
        wire.take()
    };
    let mut errors = [0; 2];
    for writes in 0.. {
        let results = [false, true].map(|is_async| {
            let wire = Wire::default();
            wire.break_after(writes);
            let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
            let transfers = Tft565::new().frame(&frame, AREAS);
            let result = if is_async { run(spi.send_async(transfers)) } else { spi.send(transfers) };
            let sent = wire.take();
            assert!(whole.starts_with(&sent), "after {writes} writes: the beginning");
            (result, sent)
        });
        assert_eq!(results[0], results[1], "after {writes} writes");
        match &results[0].0 {
            Ok(()) => break,
            Err(BusError::Bus(Broken)) => errors[0] += 1,
            Err(BusError::Pin(Broken)) => errors[1] += 1,
            Err(error) => panic!("another error: {error}"),
        }
    }
    assert!(errors[0] > 10 && errors[1] > 10, "both fail: {errors:?}");

    let memory = pictures::memory::<Pages<Lsb0<BinaryColor>>>(&mut rng, (19, 11));
    let frame = pictures::frame::<Pages<Lsb0<BinaryColor>>>(&memory, (19, 11));
    for writes in 0..6 {
        let wire = Wire::default();
        wire.break_after(writes);
        let mut i2c = I2c::new(wire.clone(), 0x3c);
        let pages = || Oled::SH1106.frame(&frame, AREAS).expect("aligned");
        assert_eq!(i2c.send(pages()), Err(BusError::Bus(Broken)), "after {writes} writes");
        assert_eq!(run(i2c.send_async(pages())), Err(BusError::Bus(Broken)), "it is still broken");
    }
}

#[test]
fn errors_say_what_failed() {
    let error: BusError<Broken, Broken> = BusError::Bus(Broken);
    assert_eq!(error.to_string(), "the bus of the display failed: Broken");
    let error: BusError<Broken, Broken> = BusError::Pin(Broken);
    assert_eq!(error.to_string(), "the data/command line of the display failed: Broken");
    let error: BusError<Broken> = BufferError::TooSmall { needed: 2, given: 1 }.into();
    assert_eq!(error.to_string(), "buffer too small: 2 bytes needed, 1 given");
}

/// DMA counts in 16 bits.
#[test]
fn long_transfers_are_cut_between_pixels() {
    let mut rng = Rng::new(1582);
    let size = (320, 240);
    let bytes: Vec<u8> = (0..320 * 240 * 2).map(|_| rng.bits() as u8).collect();
    let memory = (bytes, 640);
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, size);
    for is_async in [false, true] {
        let wire = Wire::default();
        let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
        let transfers = Tft565::new().frame(&frame, [frame.window()]);
        let sent = if is_async { run(spi.send_async(transfers)) } else { spi.send(transfers) };
        assert_eq!(sent, Ok(()));
        let packets = wire.packets();
        let pixels = &packets[5..];
        assert!(pixels.iter().all(|packet| packet.len() <= 0xffff && packet.len() % 2 == 0), "whole pixels");
        assert_eq!(pixels.len(), 3, "as few as that");
        assert_eq!(pixels.concat(), memory.0);
    }
}

/// What asks for transfers one by one sees the same.
#[test]
fn transfers_may_be_borrowed() {
    let memory = (vec![7; 8], 8);
    let frame = pictures::frame::<Rows<Be<Rgb565>>>(&memory, (4, 1));
    let mut transfers = Tft565::new().frame(&frame, [frame.window()]);
    assert_eq!(transfers.next().map(|transfer| transfer.command.to_vec()), Some(vec![0x2a]));
    let mut commands = vec![];
    (&mut transfers)
        .send(|transfer| {
            commands.extend_from_slice(transfer.command);
            Ok::<(), Broken>(())
        })
        .expect("it works");
    assert_eq!(commands, [0x2b, 0x2c]);
    assert!(transfers.next().is_none());
}
