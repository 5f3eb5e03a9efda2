//! Bands on their way to a display are the whole frame, one by one and two at a time.

use embedded_graphics_core::pixelcolor::{BinaryColor, Rgb565, RgbColor};
use embedded_raster::{
    pixel::{Be, Lsb0, EGA},
    present::{for_each_band, for_each_band_async},
    surface::{Packed12, Pages, Rows},
    Canvas, Frame, Index4, Layout, Rect,
};
use embedded_raster_displays::{BusError, Oled, Spi, Tft444, Tft565};

use crate::{
    controllers::{mipi, pages},
    wire::{run, Broken, Line, Wire},
};

const SIZE: (u16, u16) = (50, 39);

fn scene<L: Layout>(frame: &mut Frame<&mut [u8], L>, [back, front, other]: [L::Color; 3]) {
    frame.clear(back);
    frame.fill_triangle([(3, 2), (48, 20), (11, 37)], front);
    frame.draw_line((0, 38), (49, 0), other);
    frame.draw_ellipse(embedded_raster::Rect::new(9, 3, 42, 36), other);
}

/// The whole frame.
fn whole<L: Layout>(colors: [L::Color; 3]) -> Vec<u8> {
    let mut memory = vec![0; 4 * 50 * 40];
    let mut frame = Frame::<_, L>::new(&mut memory[..], SIZE.0, SIZE.1).expect("the right size");
    scene(&mut frame.as_mut(), colors);
    memory
}

const RGB: [Rgb565; 3] = [Rgb565::new(1, 2, 3), Rgb565::RED, Rgb565::CYAN];

type Error = BusError<Broken, Broken>;
type Binary = Pages<Lsb0<BinaryColor>>;

#[test]
fn bands_are_the_whole() {
    type Pixels = Rows<Be<Rgb565>>;
    let wire = Wire::default();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    let (display, memory) = (Tft565::new().with_offset(7, 9), whole::<Pixels>(RGB));
    let frame = Frame::<_, Pixels>::new(&memory[..], SIZE.0, SIZE.1).expect("the right size");
    spi.send(display.frame(&frame, [frame.window()])).expect("it works");
    let wanted = wire.take();
    let shown = mipi(&wanted, 16);
    for rows in [1, 2, 5, 16, 39, 100] {
        let (mut one, mut other) = (vec![0; 4000], vec![0xa5; 4000]);
        let (width, height) = SIZE;
        for_each_band::<Pixels, Error>(
            &mut one,
            width,
            height,
            rows,
            |band| scene(band, RGB),
            |band| spi.send(display.frame(&band, [band.window()])),
        )
        .expect("it works");
        assert_eq!(mipi(&wire.take(), 16), shown, "{rows} rows");

        // One window, and the pixels of all bands: the same bytes as those of the whole.
        spi.send(display.window(Rect::new(0, 0, 50, 39))).expect("it works");
        for_each_band::<Pixels, Error>(
            &mut one,
            width,
            height,
            rows,
            |band| scene(band, RGB),
            |band| spi.send(display.pixels(&band)),
        )
        .expect("it works");
        assert_eq!(wire.take(), wanted, "{rows} rows in one window");

        // While a band is drawn, the pixels of the one before are on their way.
        let mut drawn = 0;
        run(async {
            spi.send_async(display.window(Rect::new(0, 0, 50, 39))).await?;
            for_each_band_async::<Pixels, Error>(
                [&mut one, &mut other],
                width,
                height,
                rows,
                |band| {
                    assert_eq!(wire.in_flight(), (drawn > 0).then_some(true), "{rows} rows, band {drawn}");
                    drawn += 1;
                    scene(band, RGB);
                },
                async |band: Frame<&[u8], Pixels>| spi.send_async(display.pixels(&band)).await,
            )
            .await
        })
        .expect("it works");
        assert_eq!(wire.take(), wanted, "{rows} rows in one window, two at a time");
    }
}

#[test]
fn bands_of_indices_are_the_whole() {
    type Pixels = Rows<Index4>;
    let wire = Wire::default();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    let colors = [1, 12, 14].map(Index4::new);
    let (palette, mut line, memory) = (EGA.map(Rgb565::from), [0; 77], whole::<Pixels>(colors));
    let frame = Frame::<_, Pixels>::new(&memory[..], SIZE.0, SIZE.1).expect("the right size");
    let display = Tft565::new();
    spi.send(display.through(&frame, [frame.window()], &palette, &mut line).expect("it fits")).expect("it works");
    let wanted = wire.take();
    for rows in [1, 7, 39] {
        let mut memory = [0; 25 * 39];
        for_each_band::<Pixels, Error>(
            &mut memory,
            SIZE.0,
            SIZE.1,
            rows,
            |band| scene(band, colors),
            |band| spi.send(display.through(&band, [band.window()], &palette, &mut line).expect("it fits")),
        )
        .expect("it works");
        assert_eq!(mipi(&wire.take(), 16), mipi(&wanted, 16), "{rows} rows");
        spi.send(display.window(frame.window())).expect("it works");
        for_each_band::<Pixels, Error>(
            &mut memory,
            SIZE.0,
            SIZE.1,
            rows,
            |band| scene(band, colors),
            |band| spi.send(display.pixels_through(&band, &palette, &mut line).expect("it fits")),
        )
        .expect("it works");
        assert_eq!(wire.take(), wanted, "{rows} rows in one window");
    }
}

#[test]
fn bands_of_pairs_and_pages_are_the_whole() {
    use embedded_raster::pixel::Rgb444;
    let wire = Wire::default();
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    let colors = [0x111, 0xf08, 0x3c7].map(|bits: u32| <Rgb444 as embedded_raster::PixelFormat>::unpack(bits));
    let memory = whole::<Packed12>(colors);
    let frame = Frame::<_, Packed12>::new(&memory[..], SIZE.0, SIZE.1).expect("the right size");
    spi.send(Tft444::new().frame(&frame, [frame.window()]).expect("aligned")).expect("it works");
    let bytes = wire.take();
    let wanted = mipi(&bytes, 12);
    let mut memory = [0; 75 * 39];
    for rows in [1, 6, 39] {
        for_each_band::<Packed12, Error>(
            &mut memory,
            SIZE.0,
            SIZE.1,
            rows,
            |band| scene(band, colors),
            |band| spi.send(Tft444::new().frame(&band, [band.window()]).expect("aligned")),
        )
        .expect("it works");
        assert_eq!(mipi(&wire.take(), 12), wanted, "{rows} rows of pairs");
        spi.send(Tft444::new().window(frame.window())).expect("it works");
        for_each_band::<Packed12, Error>(
            &mut memory,
            SIZE.0,
            SIZE.1,
            rows,
            |band| scene(band, colors),
            |band| spi.send(Tft444::new().pixels(&band).expect("an even width")),
        )
        .expect("it works");
        assert_eq!(wire.take(), bytes, "{rows} rows of pairs in one window");
    }

    let colors = [BinaryColor::Off, BinaryColor::On, BinaryColor::Off];
    let memory = whole::<Binary>(colors);
    let frame = Frame::<_, Binary>::new(&memory[..], SIZE.0, SIZE.1).expect("the right size");
    for oled in [Oled::SSD1306, Oled::SH1106] {
        spi.send(oled.frame(&frame, [frame.window()]).expect("aligned")).expect("it works");
        // Bits below the last row are what was in memory before.
        let seen = |bytes: &[(bool, u8)]| {
            let mut memory = pages(bytes);
            memory.retain(|&(_, y), _| y < i32::from(SIZE.1));
            memory
        };
        let wanted = seen(&wire.take());
        for rows in [8, 16, 40] {
            let mut memory = [0; 50 * 5];
            for_each_band::<Binary, Error>(
                &mut memory,
                SIZE.0,
                SIZE.1,
                rows,
                |band| scene(band, colors),
                |band| spi.send(oled.frame(&band, [band.window()]).expect("aligned")),
            )
            .expect("it works");
            assert_eq!(seen(&wire.take()), wanted, "{rows} rows of pages");
        }
    }
}

#[test]
fn errors_of_the_bus_end_the_bands() {
    let wire = Wire::default();
    wire.break_after(9);
    let mut spi = Spi::new(wire.clone(), Line(wire.clone()));
    let sent = for_each_band::<Rows<Be<Rgb565>>, Error>(
        &mut [0; 100],
        50,
        39,
        1,
        |band| band.clear(Rgb565::RED),
        |band| spi.send(Tft565::new().frame(&band, [band.window()])),
    );
    assert!(matches!(sent, Err(BusError::Bus(Broken) | BusError::Pin(Broken))), "{sent:?}");
    let sent = for_each_band::<Rows<Be<Rgb565>>, Error>(&mut [0; 99], 50, 39, 1, |_| {}, |_| Ok(()));
    assert!(matches!(sent, Err(BusError::Buffer(_))), "{sent:?}");
}
