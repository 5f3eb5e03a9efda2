//! The list of what only a frame has.

use embedded_graphics_core::{draw_target::DrawTarget, geometry::OriginDimensions, image::GetPixel, Pixel};
use embedded_raster::{
    framebuffer,
    surface::{Packed12, Pages, Planes, Turn, Turned},
    text::{Style, FONT_6X10},
    Canvas, Frame, Index1, Index2, Layout,
};

use crate::{answer::sum, calls, Arguments};

/// A screen with memory of its own.
type Screen = framebuffer!(Index2, 5, 3);

calls! {
    /// Makes the call of a number below that of [`NAMES`] on a frame.
    NAMES, call[L: Layout](on: &mut Frame<&mut [u8], L>, a)
    {
        let (c, [width, height], [first, end]) = (a.colors[0], a.halves(0), a.halves(2));
        let mut own = Screen::new();
    }
    [Frame]
    new => Frame::<_, L>::new(a.bytes, width, height).map(|frame| a.look_at(frame));
    with_stride => {
        let stride = a.length(4);
        Frame::<_, L>::with_stride(a.bytes, width, height, stride).map(|frame| a.look_at(frame))
    };
    band => Frame::<_, L>::band(a.bytes, width, height, first..end).map(|frame| a.look_at(frame));
    as_bitmap => on.as_bitmap().get(a.points[0]) == Some(c);
    colors => sum(on.colors(a.areas[0]).map(|color| color == c));
    get => on.get(a.points[0]) == Some(c);
    size => on.size();
    stride => on.stride();
    memory => on.memory().len();
    place_of => on.place_of(a.points[0]);
    window => on.window();
    as_mut => on.as_mut().window();
    clear => on.clear(c);
    view => crate::draw(&mut on.view(a.areas[0]), a, 1);
    clipped => crate::draw(&mut on.clipped(a.areas[0]), a, 1);
    split_at_row => on.as_mut().split_at_row(a.points[0].y).map(|(mut above, mut below)| {
        crate::draw(&mut above, a, 2).wrapping_add(crate::draw(&mut below, a, 2))
    });
    // What is only to be read.
    view => a.picture.view(a.areas[0]).get(a.points[0]) == Some(c);
    clipped => a.picture.clipped(a.areas[0]).get(a.points[0]) == Some(c);
    bytes => sum(a.mask.bytes(a.areas[0]).map(<[u8]>::len));
    row_bytes => a.mask.row_bytes(first..end).len();
    page_bytes => Frame::<_, Pages<Index1>>::new(a.bytes, width, height)
        .map(|frame| frame.page_bytes(first..end).len());
    plane_bytes => Frame::<_, Planes<Index2>>::new(a.bytes, width, height)
        .map(|frame| frame.plane_bytes(a.length(3)).len());
    [Owned]
    frame => {
        own.frame().draw_line(a.points[0], a.points[1], Index2::new(3));
        own.bytes().map(usize::from)
    };
    as_bitmap => own.as_bitmap().get(a.points[0]) == Some(Index2::new(0));
    bytes => own.bytes().len();
    [Packed12]
    bytes_of => Packed12::bytes_of(width, height);
    [Turned]
    new => Turned::new(&mut *on, Turn::Quarter).fill_triangle(a.points, c);
    of_area => Turned::of_area(&mut *on, Turn::ThreeQuarters, a.areas[0]).draw_ellipse(a.areas[1], c);
    mirrored => {
        let mut turned = Turned::of_area(&mut *on, if a.flag { Turn::Half } else { Turn::Quarter }, a.areas[1]).mirrored();
        turned.draw_line(a.points[0], a.points[1], c);
        turned.blit_mask(a.points[2], &a.mask, c, None);
        Style::new(&FONT_6X10, c).draw(&mut turned, a.points[0], "Aj");
        turned.fill_rectangle(a.areas[0], c);
    };
    [Frame]
    // As embedded-graphics has it.
    size => OriginDimensions::size(on);
    pixel => on.pixel(a.points[0]) == Some(c);
    draw_iter => on.draw_iter(a.points.map(|at| Pixel(at, a.alternate(at.x)))).is_err();
    fill_contiguous => on.fill_contiguous(&a.rectangle(), a.stream()).is_err();
    fill_solid => on.fill_solid(&a.rectangle(), c).is_err();
    clear => DrawTarget::clear(on, c).is_err();
}

impl<L: Layout> Arguments<'_, L> {
    /// Reads a pixel of a frame, if it has any there.
    fn look_at(&self, frame: Frame<&[u8], L>) -> bool {
        frame.get(self.points[0]) == Some(self.colors[0])
    }

    /// Two of the numbers in 16 bits.
    pub(crate) fn halves(&self, at: usize) -> [u16; 2] {
        [at, at.wrapping_add(1)].map(|i| {
            let number = self.numbers.get(i).copied().unwrap_or_default();
            u16::try_from(number & 0xffff).unwrap_or_default()
        })
    }

    /// One of the numbers as a length; what is negative is as long as it gets.
    pub(crate) fn length(&self, at: usize) -> usize {
        self.numbers.get(at).map_or(0, |&number| usize::try_from(number).unwrap_or(usize::MAX))
    }
}
