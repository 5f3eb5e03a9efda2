//! [`File`]: SVG files, as far as paths, basic shapes, groups, transforms and flat colours go.
//!
//! What a file asks for beyond that is drawn without it, and named in [`File::unknown`]. Widths of outlines are scaled by the square
//! root of what areas are scaled by.

use std::{
    collections::{BTreeMap, BTreeSet},
    str::FromStr,
};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{Affine, Cap, FillRule, Join, Path, PathSegment, Stroke};
use fixed::types::{I16F16, I24F8};
use roxmltree::{Document, Node, ParsingOptions};
use svgtypes::{Color, Length, LengthListParser, LengthUnit, Paint, PointsParser, Transform, ViewBox};

use super::scene::{Outline, Shape};

/// How deep `use` may refer to what refers to something.
const DEPTH: usize = 16;

/// An SVG file.
#[derive(Debug)]
pub struct File {
    /// What it shows, in its own units.
    marks: Vec<Mark>,
    /// The part of the plane that it shows: left, top, width, height.
    view: [f64; 4],
    /// Width and height that it asks for, in pixels.
    size: [f64; 2],
    /// What was left out.
    pub unknown: BTreeSet<String>,
}

/// A shape with its style.
#[derive(Debug)]
struct Mark {
    data: String,
    map: Transform,
    style: Style,
}

/// What is inherited.
#[derive(Clone, Debug)]
struct Style {
    color: Rgb888,
    fill: Option<Rgb888>,
    rule: FillRule,
    stroke: Option<Rgb888>,
    width: f64,
    cap: Cap,
    join: Join,
    miter_limit: f64,
    dashes: Vec<f64>,
    phase: f64,
    is_visible: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            color: Rgb888::BLACK,
            fill: Some(Rgb888::BLACK),
            rule: FillRule::NonZero,
            stroke: None,
            width: 1.0,
            cap: Cap::Butt,
            join: Join::Miter,
            miter_limit: 4.0,
            dashes: vec![],
            phase: 0.0,
            is_visible: true,
        }
    }
}

impl File {
    /// Reads a file.
    ///
    /// # Errors
    /// If it is not XML, or not SVG: in a line.
    pub fn parse(text: &str) -> Result<Self, String> {
        let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, options).map_err(|error| error.to_string())?;
        let root = document.root_element();
        if root.tag_name().name() != "svg" {
            return Err(format!("`{}` is no SVG", root.tag_name().name()));
        }
        let mut reader =
            Reader { document: &document, marks: vec![], unknown: BTreeSet::new(), rules: BTreeMap::new() };
        reader.read_rules();
        let view = root.attribute("viewBox").and_then(|text| ViewBox::from_str(text).ok());
        let asked = |name: &str| root.attribute(name).and_then(|text| Length::from_str(text).ok());
        let pixels =
            |length: Option<Length>| length.filter(|l| l.unit != LengthUnit::Percent).map(|l| l.number * unit(l.unit));
        let [width, height] = ["width", "height"].map(|name| pixels(asked(name)));
        let size = match (view, width, height) {
            (_, Some(width), Some(height)) => [width, height],
            (Some(view), Some(width), None) => [width, width * view.h / view.w],
            (Some(view), None, Some(height)) => [height * view.w / view.h, height],
            (Some(view), None, None) => [view.w, view.h],
            (None, width, height) => [width.unwrap_or(100.0), height.unwrap_or(100.0)],
        };
        let view = view.map_or([0.0, 0.0, size[0], size[1]], |view| [view.x, view.y, view.w, view.h]);
        reader.read(root, &Style::default(), Transform::default(), 0);
        Ok(Self { marks: reader.marks, view, size, unknown: reader.unknown })
    }

    /// The pixels that it asks for, from 1 to 4096 in each direction.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is clamped")]
    pub fn size(&self) -> (u16, u16) {
        let [width, height] = self.size.map(|n| n.round().clamp(1.0, 4096.0) as u16);
        (width, height)
    }

    /// The path data of its shapes, as SVG has it: that of basic shapes is made here.
    pub fn data(&self) -> impl Iterator<Item = &str> {
        self.marks.iter().map(|mark| mark.data.as_str())
    }

    /// Its shapes on a screen of this size, in the middle and as large as they fit, and then mapped by the six numbers that SVG
    /// calls `matrix`. What turns out to be unknown is added to the rest of it.
    pub fn shapes(&mut self, (width, height): (u16, u16), then: [f64; 6], min_width: I24F8) -> Vec<Shape> {
        let [left, top, wide, high] = self.view;
        let (width, height) = (f64::from(width), f64::from(height));
        let scale = (width / wide).min(height / high);
        let fit = Transform::new(
            scale,
            0.0,
            0.0,
            scale,
            (width - scale * wide) / 2.0 - scale * left,
            (height - scale * high) / 2.0 - scale * top,
        );
        let [a, b, c, d, e, f] = then;
        let fit = product(Transform::new(a, b, c, d, e, f), fit);
        let mut shapes = vec![];
        for mark in &self.marks {
            let map = product(fit, mark.map);
            let path = segments(&mark.data, map, &mut self.unknown);
            let grows = (map.a * map.d - map.b * map.c).abs().sqrt();
            let even = (map.a - map.d).hypot(map.b + map.c).min((map.a + map.d).hypot(map.b - map.c));
            if mark.style.stroke.is_some() && even > 1e-3 * grows {
                self.unknown.insert("outlines that are wider in one direction than in the other".into());
            }
            let length = |n: f64| I24F8::saturating_from_num(n * grows);
            let outline = mark.style.stroke.filter(|_| mark.style.width > 0.0).map(|color| Outline {
                stroke: Stroke::new(length(mark.style.width))
                    .with_cap(mark.style.cap)
                    .with_join(mark.style.join)
                    .with_miter_limit(I24F8::saturating_from_num(mark.style.miter_limit))
                    .with_min_width(min_width),
                dashes: mark.style.dashes.iter().map(|&n| length(n)).collect(),
                phase: length(mark.style.phase),
                color,
            });
            let fill = mark.style.fill.map(|color| (mark.style.rule, color));
            shapes.push(Shape { path, fill, drop_out: None, outline });
        }
        shapes
    }
}

/// First `b`, then `a`.
fn product(a: Transform, b: Transform) -> Transform {
    Transform::new(
        a.a * b.a + a.c * b.b,
        a.b * b.a + a.d * b.b,
        a.a * b.c + a.c * b.d,
        a.b * b.c + a.d * b.d,
        a.a * b.e + a.c * b.f + a.e,
        a.b * b.e + a.d * b.f + a.f,
    )
}

/// Path data as it is on the screen. Of data that makes no sense, what comes before.
fn segments(data: &str, map: Transform, unknown: &mut BTreeSet<String>) -> Vec<PathSegment> {
    let number = I16F16::saturating_from_num::<f64>;
    let map = Affine {
        xx: number(map.a),
        xy: number(map.c),
        dx: number(map.e),
        yx: number(map.b),
        yy: number(map.d),
        dy: number(map.f),
    };
    let mut data = data;
    loop {
        match Path::svg(data) {
            Ok(path) => return path.mapped(map).collect(),
            Err(error) => {
                unknown.insert(format!("path data: {error}"));
                data = &data[..error.position];
                data = &data[..data.rfind(|c: char| c.is_ascii_alphabetic()).unwrap_or(0)];
            }
        }
    }
}

/// Pixels of a unit.
fn unit(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em | LengthUnit::Pc => 16.0,
        LengthUnit::Ex => 8.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 96.0 / 72.0,
        LengthUnit::Percent => 0.01,
    }
}

fn rgb(color: Color) -> Rgb888 {
    Rgb888::new(color.red, color.green, color.blue)
}

/// Goes over a document.
struct Reader<'a, 'input> {
    document: &'a Document<'input>,
    marks: Vec<Mark>,
    unknown: BTreeSet<String>,
    /// Declarations of a style sheet, by their simple selectors: `path`, `.class`, `#id`.
    rules: BTreeMap<String, Vec<(String, String)>>,
}

fn declarations(text: &str) -> impl Iterator<Item = (String, String)> + '_ {
    let parts = text.split(';').filter_map(|part| part.split_once(':'));
    parts.map(|(name, value)| (name.trim().into(), value.trim_end_matches("!important").trim().into()))
}

impl<'a, 'input: 'a> Reader<'a, 'input> {
    fn read_rules(&mut self) {
        for sheet in self.document.descendants().filter(|node| node.tag_name().name() == "style") {
            for rule in sheet.text().unwrap_or_default().split('}') {
                let Some((selectors, body)) = rule.split_once('{') else { continue };
                for selector in selectors.split(',').map(str::trim) {
                    let simple = selector.trim_start_matches(['.', '#']);
                    if simple.is_empty() || !simple.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_') {
                        self.unknown.insert(format!("the selector `{selector}`"));
                        continue;
                    }
                    self.rules.entry(selector.into()).or_default().extend(declarations(body));
                }
            }
        }
    }

    /// All that is said of a node: attributes, then the style sheet, then its own style.
    fn said(&self, node: Node<'a, 'input>) -> BTreeMap<String, String> {
        let mut all: BTreeMap<String, String> =
            node.attributes().map(|attribute| (attribute.name().into(), attribute.value().into())).collect();
        let mut selectors = vec![node.tag_name().name().to_owned()];
        let classes = node.attribute("class").unwrap_or_default().split_whitespace();
        selectors.extend(classes.map(|class| format!(".{class}")));
        selectors.extend(node.attribute("id").map(|id| format!("#{id}")));
        for rule in selectors.iter().filter_map(|selector| self.rules.get(selector)) {
            all.extend(rule.iter().cloned());
        }
        all.extend(declarations(node.attribute("style").unwrap_or_default()));
        all
    }

    fn read(&mut self, node: Node<'a, 'input>, inherited: &Style, map: Transform, depth: usize) {
        let name = node.tag_name().name();
        let said = self.said(node);
        let get = |name: &str| said.get(name).map(String::as_str);
        if get("display") == Some("none") || get("opacity").and_then(|n| n.parse::<f64>().ok()) == Some(0.0) {
            return;
        }
        let style = self.style(&said, inherited);
        let map = match get("transform").map(Transform::from_str) {
            Some(Ok(own)) => product(map, own),
            Some(Err(error)) => {
                self.unknown.insert(format!("a transform: {error}"));
                map
            }
            None => map,
        };
        for what in ["mask", "clip-path", "filter", "marker-start", "marker-mid", "marker-end", "marker"] {
            if get(what).is_some_and(|value| value != "none") {
                self.unknown.insert(format!("the attribute `{what}`"));
            }
        }
        match name {
            "svg" | "g" | "a" | "switch" | "symbol" => {
                let inner = if name == "svg" && depth > 0 {
                    let at = |name| get(name).and_then(|text| self.length(text, 0)).unwrap_or(0.0);
                    product(map, Transform::new(1.0, 0.0, 0.0, 1.0, at("x"), at("y")))
                } else {
                    map
                };
                for child in node.children().filter(Node::is_element) {
                    if child.tag_name().name() != "symbol" {
                        self.read(child, &style, inner, depth + 1);
                    }
                }
            }
            "use" => {
                let href = node.attributes().find(|attribute| attribute.name() == "href").map(|a| a.value());
                let id = href.and_then(|href| href.strip_prefix('#'));
                let target =
                    id.and_then(|id| self.document.descendants().find(|node| node.attribute("id") == Some(id)));
                let Some(target) = target.filter(|_| depth < DEPTH) else {
                    self.unknown.insert("a `use` of something that is not there".into());
                    return;
                };
                let at = |name| get(name).and_then(|text| self.length(text, 0)).unwrap_or(0.0);
                let map = product(map, Transform::new(1.0, 0.0, 0.0, 1.0, at("x"), at("y")));
                self.read(target, &style, map, depth + 1);
            }
            "defs" | "title" | "desc" | "metadata" | "style" | "namedview" | "script" | "linearGradient"
            | "radialGradient" | "clipPath" | "mask" | "filter" | "marker" | "pattern" | "SVGTestCase" => {}
            _ => match self.data(name, &said) {
                Some(data) if style.is_visible => self.marks.push(Mark { data, map, style }),
                Some(_) => {}
                None => {
                    self.unknown.insert(format!("the element `{name}`"));
                }
            },
        }
    }

    /// A length in the units of the file; of a per cent, the share of the root's width, height, or of a mean of both.
    fn length(&self, text: &str, axis: usize) -> Option<f64> {
        let length = Length::from_str(text).ok()?;
        if length.unit != LengthUnit::Percent {
            return Some(length.number * unit(length.unit));
        }
        let root = self.document.root_element();
        let view = root.attribute("viewBox").and_then(|text| ViewBox::from_str(text).ok());
        let size = view.map_or([100.0, 100.0], |view| [view.w, view.h]);
        let whole = match axis {
            0 => size[0],
            1 => size[1],
            _ => (size[0].hypot(size[1])) / 2_f64.sqrt(),
        };
        Some(length.number / 100.0 * whole)
    }

    /// The path data of a shape; `None` if it is none.
    fn data(&self, name: &str, said: &BTreeMap<String, String>) -> Option<String> {
        let number = |name: &str, axis: usize| said.get(name).and_then(|text| self.length(text, axis));
        let [x, y] = [("x", 0), ("y", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
        let [cx, cy] = [("cx", 0), ("cy", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
        let ellipse = |rx: f64, ry: f64| {
            if rx <= 0.0 || ry <= 0.0 {
                return String::new();
            }
            let d = 2.0 * rx;
            format!("M{:.9} {cy:.9}a{rx:.9} {ry:.9} 0 1 1 -{d:.9} 0a{rx:.9} {ry:.9} 0 1 1 {d:.9} 0z", cx + rx)
        };
        let points = || {
            let points = PointsParser::from(said.get("points").map_or("", String::as_str));
            let text = points.map(|(x, y)| format!("{x:.9},{y:.9}")).collect::<Vec<_>>().join(" ");
            if text.is_empty() {
                text
            } else {
                format!("M{text}")
            }
        };
        Some(match name {
            "path" => said.get("d").cloned().unwrap_or_default(),
            "circle" => {
                let r = number("r", 2).unwrap_or(0.0);
                ellipse(r, r)
            }
            "ellipse" => ellipse(number("rx", 0).unwrap_or(0.0), number("ry", 1).unwrap_or(0.0)),
            "line" => {
                let [a, b] = [("x1", 0), ("y1", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
                let [c, d] = [("x2", 0), ("y2", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
                format!("M{a:.9} {b:.9}L{c:.9} {d:.9}")
            }
            "polyline" => points(),
            "polygon" => points() + if points().is_empty() { "" } else { "z" },
            "rect" => {
                let [w, h] = [("width", 0), ("height", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
                if w <= 0.0 || h <= 0.0 {
                    return Some(String::new());
                }
                let (rx, ry) = (number("rx", 0), number("ry", 1));
                let rx = rx.or(ry).unwrap_or(0.0).clamp(0.0, w / 2.0);
                let ry = ry.or(number("rx", 0)).unwrap_or(0.0).clamp(0.0, h / 2.0);
                if rx == 0.0 || ry == 0.0 {
                    return Some(format!("M{x:.9} {y:.9}h{w:.9}v{h:.9}h-{w:.9}z"));
                }
                let (a, b) = (w - 2.0 * rx, h - 2.0 * ry);
                let arc = format!("a{rx:.9} {ry:.9} 0 0 1 ");
                format!(
                    "M{:.9} {y:.9}h{a:.9}{arc}{rx:.9} {ry:.9}v{b:.9}{arc}-{rx:.9} {ry:.9}h-{a:.9}{arc}-{rx:.9} -{ry:.9}v-{b:.9}{arc}{rx:.9} -{ry:.9}z",
                    x + rx
                )
            }
            _ => return None,
        })
    }

    /// What a node makes of the style that it inherits.
    fn style(&mut self, said: &BTreeMap<String, String>, inherited: &Style) -> Style {
        let mut style = inherited.clone();
        let get = |name: &str| said.get(name).map(String::as_str).filter(|value| *value != "inherit");
        if let Some(Ok(color)) = get("color").map(Color::from_str) {
            style.color = rgb(color);
        }
        style.fill = self.paint(get("fill"), style.fill, style.color);
        style.stroke = self.paint(get("stroke"), style.stroke, style.color);
        for (name, paint) in [("fill-opacity", &mut style.fill), ("stroke-opacity", &mut style.stroke)] {
            match get(name).and_then(|text| text.parse::<f64>().ok()) {
                Some(0.0) => *paint = None,
                Some(n) if n < 1.0 => _ = self.unknown.insert(format!("the attribute `{name}`")),
                _ => {}
            }
        }
        if get("opacity").and_then(|text| text.parse::<f64>().ok()).is_some_and(|n| n < 1.0) {
            self.unknown.insert("the attribute `opacity`".into());
        }
        match get("fill-rule") {
            Some("evenodd") => style.rule = FillRule::EvenOdd,
            Some("nonzero") => style.rule = FillRule::NonZero,
            _ => {}
        }
        match get("stroke-linecap") {
            Some("butt") => style.cap = Cap::Butt,
            Some("square") => style.cap = Cap::Square,
            Some("round") => style.cap = Cap::Round,
            _ => {}
        }
        match get("stroke-linejoin") {
            Some("bevel") => style.join = Join::Bevel,
            Some("round") => style.join = Join::Round,
            Some("miter") => style.join = Join::Miter,
            Some(other) => _ = self.unknown.insert(format!("the join `{other}`")),
            None => {}
        }
        let number = |name: &str| get(name).and_then(|text| self.length(text, 2));
        style.width = number("stroke-width").unwrap_or(style.width);
        style.miter_limit = number("stroke-miterlimit").unwrap_or(style.miter_limit);
        style.phase = number("stroke-dashoffset").unwrap_or(style.phase);
        if let Some(text) = get("stroke-dasharray") {
            let lengths = LengthListParser::from(text).flatten().map(|length| length.number * unit(length.unit));
            style.dashes = if text == "none" { vec![] } else { lengths.collect() };
            if style.dashes.iter().sum::<f64>() <= 0.0 {
                style.dashes.clear();
            }
        }
        match get("visibility") {
            Some("hidden" | "collapse") => style.is_visible = false,
            Some("visible") => style.is_visible = true,
            _ => {}
        }
        style
    }

    fn paint(&mut self, text: Option<&str>, inherited: Option<Rgb888>, current: Rgb888) -> Option<Rgb888> {
        match text.map(Paint::from_str) {
            Some(Ok(Paint::None)) => None,
            Some(Ok(Paint::CurrentColor)) => Some(current),
            Some(Ok(Paint::Color(color))) if color.alpha == 0 => None,
            Some(Ok(Paint::Color(color))) => Some(rgb(color)),
            Some(Ok(Paint::FuncIRI(id, _))) => {
                self.unknown.insert("gradients and patterns".into());
                Some(self.first_stop(id).unwrap_or(Rgb888::new(128, 128, 128)))
            }
            None | Some(Ok(Paint::Inherit | Paint::ContextFill | Paint::ContextStroke)) => inherited,
            Some(Err(_)) => {
                self.unknown.insert(format!("the colour `{}`", text.unwrap_or_default()));
                inherited
            }
        }
    }

    /// The first colour of a gradient.
    fn first_stop(&self, id: &str) -> Option<Rgb888> {
        let gradient = self.document.descendants().find(|node| node.attribute("id") == Some(id))?;
        let stop = gradient.children().find(|node| node.tag_name().name() == "stop")?;
        let said = self.said(stop);
        Color::from_str(said.get("stop-color")?).ok().map(rgb)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::{draw, Screen};

    const SIZE: (u16, u16) = (20, 20);

    /// The pixels that a file paints on a screen of 20 x 20, and what was left out.
    fn drawn(body: &str) -> (Vec<[usize; 2]>, Vec<String>) {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 20'>{body}</svg>");
        let mut file = File::parse(&text).expect("an SVG file");
        let shapes = file.shapes(SIZE, [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO);
        let screen = Screen { width: 20, height: 20, bits: 24, band: 20, slots: 999, paper: Rgb888::WHITE };
        let picture = draw(&shapes, &screen).expect("enough slots").picture;
        let all = (0..20).flat_map(|y| (0..20).map(move |x| [x, y]));
        let pixels = all.filter(|&[x, y]| picture.color(x, y) != Some(Rgb888::WHITE)).collect();
        (pixels, file.unknown.into_iter().collect())
    }

    fn same(a: &str, b: &str) {
        let (first, second) = (drawn(a), drawn(b));
        assert!(!first.0.is_empty() && first.1.is_empty(), "{a}: {first:?}");
        assert_eq!(first, second, "{a} and {b}");
    }

    #[test]
    fn shapes_are_paths() {
        same("<rect x='2' y='3' width='10' height='5'/>", "<path d='M2 3h10v5h-10z'/>");
        same("<rect x='2' y='3' width='10' height='6' rx='3'/>", "<path d='M5 3h4a3 3 0 0 1 0 6h-4a3 3 0 0 1 0-6z'/>");
        same("<circle cx='9' cy='9' r='7'/>", "<ellipse cx='9' cy='9' rx='7' ry='7'/>");
        same("<polygon points='1,1 18,4 5 17'/>", "<polyline points='1,1 18,4 5 17'/>");
        let line = "<line x1='2' y1='2' x2='17' y2='9' stroke='red' stroke-width='3'/>";
        same(line, "<path d='M2 2 17 9' stroke='red' stroke-width='3'/>");
    }

    #[test]
    fn styles_and_maps_are_inherited() {
        let square = "<rect x='4' y='4' width='8' height='8'/>";
        same(&format!("<g transform='translate(3 2) scale(.5)'>{square}</g>"), "<path d='M5 4h4v4h-4z'/>");
        same(
            &format!("<g fill='none' stroke='blue' stroke-width='2'>{square}</g>"),
            "<path fill-rule='evenodd' d='M3 3h10v10h-10zM5 5v6h6v-6z'/>",
        );
        same(
            &format!(
                "<style>.a, rect {{ fill: none }} .a{{stroke:#123;stroke-width:2px}}</style><g class='a'>{square}</g>"
            ),
            "<path fill-rule='evenodd' d='M3 3h10v10h-10zM5 5v6h6v-6z'/>",
        );
        same(&format!("<defs><g id='s'>{square}</g></defs><use href='#s' x='2'/>"), "<path d='M6 4h8v8h-8z'/>");
        same(
            &format!("<g display='none'><circle r='9'/></g><g style='visibility:hidden'><circle r='9'/></g>{square}"),
            square,
        );
        assert_eq!(drawn("<g fill='none'><rect width='9' height='9'/></g>").0, Vec::<[usize; 2]>::new());
    }

    #[test]
    fn what_is_unknown_has_a_name() {
        let unknown = |body: &str| drawn(body).1.join("; ");
        assert_eq!(unknown("<text>words</text>"), "the element `text`");
        assert_eq!(unknown("<path d='M2 2h5v5z' fill='url(#x)'/>"), "gradients and patterns");
        assert_eq!(unknown("<path d='M2 2h5v5z' opacity='.5'/>"), "the attribute `opacity`");
        assert_eq!(unknown("<path d='M2 2h5v5z' clip-path='url(#x)'/>"), "the attribute `clip-path`");
        assert_eq!(unknown("<use href='#nothing'/>"), "a `use` of something that is not there");
        let (pixels, unknown) = drawn("<path d='M2 2h5v5L9 x'/>");
        assert_eq!((pixels.len(), &unknown.join("; ")[..]), (15, "path data: position 11: a number is expected"));
        assert!(File::parse("<html/>").is_err_and(|error| error == "`html` is no SVG"));
        assert!(File::parse("<svg").is_err_and(|error| !error.contains('\n')));
        let deep = "<g id='a'><use href='#a'/></g>";
        assert_eq!(drawn(deep).1, ["a `use` of something that is not there"], "a circle of references ends");
    }
}
