//! Screens that hold their own memory.

use std::mem::{align_of, size_of};

use embedded_graphics_core::pixelcolor::{BinaryColor, Gray2, Rgb565};
use embedded_raster::{
    buffer_bytes, framebuffer,
    pixel::{Be, Lsb0, Rgb444},
    surface::{paged_bytes, Owned, Packed12, Pages, Planes},
    Canvas, Frame, Framebuffer, Index1, Index4, Layout, PixelFormat, Readable, Rect, Surface,
};
use static_cell::ConstStaticCell;

type Screen = framebuffer!(Index4, 65, 9);

/// The same lines on a frame and on one of memory that was given.
fn as_given<L: Layout, F: PixelFormat<Color = L::Color>>(mut frame: Frame<&mut [u8], L>, (width, height): (u16, u16)) {
    let mut given = vec![0; 1_000];
    let mut other = Frame::<_, L>::new(&mut given[..], width, height).expect("it is large enough");
    let color = F::unpack(1);
    let draw = |mut on: Frame<&mut [u8], L>| {
        on.draw_line((-3, -2), (i32::from(width), i32::from(height)), color);
        on.draw_rectangle(Rect::new(0, 0, width.into(), height.into()), color);
    };
    draw(frame.as_mut());
    draw(other.as_mut());
    assert_eq!((frame.window(), frame.stride(), frame.size()), (other.window(), other.stride(), other.size()));
    assert!(frame.colors(frame.window()).eq(other.colors(other.window())));
    assert!(frame.color_at(i32::from(width) - 1, 0) == color);
}

#[test]
fn every_layout_can_be_owned() {
    as_given::<_, Index4>(Screen::new().frame(), (65, 9));
    as_given::<_, Rgb565>(<framebuffer!(Be<Rgb565>, 20, 11)>::new().frame(), (20, 11));
    as_given::<_, BinaryColor>(
        Owned::<Pages<Lsb0<BinaryColor>>, 13, 20, { paged_bytes(13, 20) }>::new().frame(),
        (13, 20),
    );
    as_given::<_, Gray2>(Owned::<Planes<Gray2>, 17, 5, { 2 * buffer_bytes::<Index1>(17, 5) }>::new().frame(), (17, 5));
    as_given::<_, Rgb444>(Owned::<Packed12, 7, 5, { Packed12::bytes_of(7, 5) }>::new().frame(), (7, 5));
    assert_eq!(<framebuffer!(Index4, 0, 0)>::new().frame().window(), Rect::new(0, 0, 0, 0));
}

#[test]
fn it_is_its_pixels_and_no_more() {
    assert_eq!((size_of::<Screen>(), align_of::<Screen>()), (33 * 9 + 3, 4), "to whole words");
    let screen = Screen::new();
    assert_eq!(screen.bytes(), &[0; 33 * 9]);
    assert_eq!(format!("{screen:?}"), "Owned { width: 65, height: 9, bytes: 297, .. }");
}

#[test]
fn a_static_is_lent_out() {
    static SCREEN: ConstStaticCell<Screen> = ConstStaticCell::new(Screen::new());
    let screen = SCREEN.take();
    let mut frame: Framebuffer<'_, Index4> = screen.frame();
    frame.set((64, 8).into(), Index4::new(9));
    assert_eq!(screen.as_bitmap().get((64, 8)), Some(Index4::new(9)));
    assert_eq!(screen.bytes()[296], 0x90);
}
