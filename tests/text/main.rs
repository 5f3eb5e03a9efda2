//! Text: fonts as bytes, and lines of glyphs against their pixels in every layout.

mod draw;
mod font;
