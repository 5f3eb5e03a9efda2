//! What a strip of LEDs is sent by ws2812-spi.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{pixel::EGA, surface::Rows, Index4};
use embedded_raster_displays::leds::{grb, leds, Wiring};
use smart_leds_trait::{SmartLedsWrite, RGB8};
use twins::rng::Rng;
use ws2812_spi::Ws2812;

use crate::{pictures, wire::Wire};

/// Each bit of a strip is four of SPI: 1000 is zero, 1110 is one.
fn bytes_of_a_strip(spi: &[(bool, u8)]) -> Vec<u8> {
    let bits = spi.iter().take_while(|(_, byte)| *byte != 0).flat_map(|(_, byte)| [byte >> 4, byte & 15]);
    let bits: Vec<u8> = bits.map(|four| u8::from(four == 0b1110)).collect();
    bits.chunks(8).map(|bits| bits.iter().fold(0, |byte, bit| byte << 1 | bit)).collect()
}

/// A matrix of a strip: the lines one after the other, turned over where the wiring says so.
fn places(wiring: Wiring, width: u16, height: u16) -> Vec<(i32, i32)> {
    let (width, height) = (i32::from(width), i32::from(height));
    let mut lines: Vec<Vec<(i32, i32)>> = if wiring.in_columns {
        (0..width).map(|x| (0..height).map(|y| (x, y)).collect()).collect()
    } else {
        (0..height).map(|y| (0..width).map(|x| (x, y)).collect()).collect()
    };
    if wiring.is_serpentine {
        lines.iter_mut().skip(1).step_by(2).for_each(|line| line.reverse());
    }
    let turned = |(x, y): (i32, i32)| {
        let x = if wiring.from_right { width - 1 - x } else { x };
        (x, if wiring.from_bottom { height - 1 - y } else { y })
    };
    lines.concat().into_iter().map(turned).collect()
}

#[test]
fn strips_are_sent_by_ws2812_spi() {
    let mut rng = Rng::new(1540);
    for number in 0..64 {
        let wiring = Wiring {
            is_serpentine: number & 1 != 0,
            in_columns: number & 2 != 0,
            from_right: number & 4 != 0,
            from_bottom: number & 8 != 0,
        };
        let size = pictures::sizes(&mut rng);
        let memory = pictures::memory::<Rows<Index4>>(&mut rng, size);
        let frame = pictures::frame::<Rows<Index4>>(&memory, size);
        let color = |index: Option<Index4>| index.and_then(|index| EGA.get(index.index())).unwrap_or(Rgb888::BLACK);

        let wire = Wire::default();
        let mut strip = Ws2812::new(wire.clone());
        let pixels = leds(&frame, wiring, |index| {
            let color = color(index);
            RGB8::new(color.r(), color.g(), color.b())
        });
        strip.write(pixels).expect("it works");
        let sent = bytes_of_a_strip(&wire.take());
        let wanted: Vec<u8> =
            places(wiring, size.0, size.1).into_iter().flat_map(|place| grb(color(frame.get(place)))).collect();
        assert_eq!(sent, wanted, "{wiring:?} of {size:?}");
        let bytes: Vec<u8> = leds(&frame, wiring, |index| grb(color(index))).flatten().collect();
        assert_eq!(bytes, wanted, "{wiring:?} of {size:?}, without a driver");
    }
}

#[test]
fn a_matrix_without_pixels_has_no_leds() {
    for size in [(0, 0), (0, 7), (7, 0)] {
        for wiring in [Wiring::SERPENTINE, Wiring { in_columns: true, ..Wiring::SERPENTINE }] {
            assert_eq!(wiring.place(0, size.0, size.1), None, "{size:?}");
        }
    }
    assert_eq!(Wiring::default().place(u32::MAX, u16::MAX, u16::MAX), None, "too many");
}
