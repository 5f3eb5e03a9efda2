//! [`text`]: the letters of labels.

use embedded_graphics::mono_font::ascii::FONT_6X10;
use embedded_graphics::mono_font::MonoTextStyleBuilder;
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;

use super::{Ink, Label};

/// Draws text as embedded-graphics does it, on any target.
pub fn text<F: DrawTarget>(
    frame: &mut F,
    labels: &[Label<'_>],
    colour: impl Fn(Ink) -> F::Color,
) -> Result<(), F::Error> {
    for label in labels {
        let style = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(colour(label.ink));
        let style = match label.paper {
            Some(paper) => style.background_color(colour(paper)).build(),
            None => style.build(),
        };
        Text::new(label.text, label.at, style).draw(frame)?;
    }
    Ok(())
}
