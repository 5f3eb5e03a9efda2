//! The list of text: fonts out of any bytes, and what is drawn and measured with them.

use embedded_graphics_core::geometry::Point;
use embedded_raster::{
    text::{Font, Horizontal, Style, Vertical, FONT_6X10},
    Layout, Surface,
};

use crate::{calls, Arguments};

calls! {
    /// Makes the call of a number below that of [`NAMES`] on a surface, with the bytes of the arguments as a font, if they are one, and
    /// as far as they are one, as a text.
    NAMES, call[S: Surface<Color = L::Color>, L: Layout](on: &mut S, a)
    {
        let font = Font::read(a.bytes).unwrap_or(FONT_6X10);
        let text = a.bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
        let ([c, ground], at) = (a.colors, a.points[0]);
        let style = a.style(&font);
    }
    [Font]
    read => Font::read(a.bytes).map(|font| font.len());
    height => font.height();
    baseline => font.baseline();
    len => font.len();
    is_empty => font.is_empty();
    overhangs => font.overhangs();
    has => text.chars().any(|character| font.has(character));
    glyph => text.chars().map(|character| font.glyph(character).strips.len()).fold(0, usize::wrapping_add);
    width => font.width(text);
    [Style]
    new => Style::new(&font, c).draw(on, at, text);
    color => style.color(ground).draw(on, at, text);
    opaque => style.opaque(ground).draw(on, at, text);
    horizontal => style.horizontal(Horizontal::Center).draw(on, at, text);
    vertical => style.vertical(Vertical::Middle).draw(on, at, text);
    line_height => style.line_height(a.halves(0)[0]).draw(on, at, text);
    tab => style.tab(a.halves(2)[0]).draw(on, at, text);
    size => style.size(text);
    bounds => style.bounds(at, text);
    draw => {
        style.draw(on, at, text);
        // Across each side of the window.
        let window = on.window();
        style.draw(on, Point::new(window.x0.saturating_sub(3), window.y1), "Aj\tg\n|");
        style.draw(on, Point::new(window.x1.saturating_sub(9), window.y0), "Aj\tg\n|");
    };
}

impl<L: Layout> Arguments<'_, L> {
    /// A style of any kind.
    fn style<'a>(&self, font: &'a Font<'a>) -> Style<'a, L::Color> {
        let [first, second] = self.halves(4);
        let style = Style::new(font, self.colors[0])
            .horizontal(
                [Horizontal::Left, Horizontal::Center, Horizontal::Right, Horizontal::Right][usize::from(first & 3)],
            )
            .vertical([Vertical::Top, Vertical::Baseline, Vertical::Middle, Vertical::Bottom][usize::from(second & 3)]);
        if self.flag {
            style.opaque(self.colors[1])
        } else {
            style
        }
    }
}
