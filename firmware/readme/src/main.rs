// cargo add cortex-m-rt embedded-raster panic-halt
#![no_std]
#![no_main]
use embedded_raster::{framebuffer, Canvas, EdgeSlot, FillRule, Index4, PointFx};
use panic_halt as _;

type Screen = framebuffer!(Index4, 64, 48); // 1,536 bytes

#[cortex_m_rt::entry]
fn main() -> ! {
    static mut SCREEN: Screen = Screen::new(); // `entry` lends it out once, as `&mut`: no heap, no `unsafe`
    let mut frame = SCREEN.frame();
    let (sea, land, border) = (Index4::new(1), Index4::new(2), Index4::new(15));
    let island = [(8, 30), (20, 9), (37, 16), (56, 12), (49, 40), (24, 44)].map(|(x, y)| PointFx::px(x, y));
    let mut table = [EdgeSlot::EMPTY; 8]; // scratch: at most 8 sides of the outline cross a row
    frame.clear(sea);
    frame.fill_polygon_fx(&island, FillRule::EvenOdd, &mut table, land).unwrap();
    frame.draw_line((20, 9), (49, 40), border);
    loop {
        core::hint::black_box(frame.row_bytes(0..48)); // send these to the display
    }
}
