//! [`File`]: SVG files, as far as paths, basic shapes, groups, transforms and flat colours go.
//!
//! What a file asks for beyond that is drawn without it, and named in [`File::unknown`]. Widths of outlines are scaled by the square
//! root of what areas are scaled by.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    rc::Rc,
    str::FromStr,
};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{Affine, Cap, FillRule, Join, Path, PathSegment, PointFx, Stroke, SvgError};
use fixed::types::{I16F16, I24F8};
use roxmltree::{Document, Node, ParsingOptions};
use simplecss::{DeclarationTokenizer, StyleSheet};
use svgtypes::{
    Align, AspectRatio, Color, Length, LengthListParser, LengthUnit, Paint, PaintFallback, PointsParser, Transform,
    ViewBox,
};

use super::{
    numbers,
    scene::{Outline, Shape},
    sheet::{self, Styled},
};

/// How deep `use` may refer to what refers to something.
const DEPTH: usize = 16;
/// How deep elements may lie in each other.
const NESTED: usize = 512;
/// How much is drawn, in bytes of path data, with as many for each element: uses of uses make a large picture of a small file.
const MOST: usize = 1 << 26;
const ELEMENT: usize = 64;

/// Attributes that are named, and not followed.
const LEFT_OUT: [&str; 9] = [
    "mask",
    "clip-path",
    "filter",
    "marker-start",
    "marker-mid",
    "marker-end",
    "marker",
    "transform-origin",
    "mix-blend-mode",
];

/// Attributes that are one length, and the elements that look at them.
const LENGTHS: [&str; 13] = ["x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "x1", "y1", "x2", "y2"];
const MEASURED: [&str; 7] = ["rect", "circle", "ellipse", "line", "use", "svg", "symbol"];

/// An SVG file.
#[derive(Debug)]
pub struct File {
    /// What it shows, in its own units.
    marks: Vec<Mark>,
    /// The part of the plane that it shows: left, top, width, height.
    view: [f64; 4],
    /// Width and height that it asks for, in pixels.
    size: [f64; 2],
    /// Where the part lies on a screen that is wider or higher.
    aspect: AspectRatio,
    /// What was left out.
    pub unknown: BTreeSet<String>,
    /// Path data that makes no sense, with its line and what is wrong: it is drawn as far as it does.
    pub errors: Vec<String>,
}

/// A shape with its style.
#[derive(Debug)]
struct Mark {
    data: Rc<str>,
    map: Transform,
    style: Style,
}

/// What is inherited.
#[derive(Clone, Debug)]
struct Style {
    color: Rgb888,
    fill: Ink,
    rule: FillRule,
    stroke: Ink,
    width: f64,
    /// The width is one on the screen, whatever the map.
    is_fixed: bool,
    cap: Cap,
    join: Join,
    miter_limit: f64,
    dashes: Vec<f64>,
    phase: f64,
    is_visible: bool,
    /// The outline is painted before the inside.
    is_outline_first: bool,
    measure: Measure,
}

/// What lengths are of.
#[derive(Copy, Clone, Debug)]
struct Measure {
    /// Per cents: width and height of the part of the plane that is shown.
    whole: [f64; 2],
    /// The size of the font.
    em: f64,
}

/// What a shape is painted with.
#[derive(Copy, Clone, Debug)]
enum Ink {
    None,
    Color(Rgb888),
    /// That of the attribute `color`, where it is painted.
    Current,
}

impl Ink {
    fn color(self, current: Rgb888) -> Option<Rgb888> {
        match self {
            Self::None => None,
            Self::Color(color) => Some(color),
            Self::Current => Some(current),
        }
    }
}

impl Default for Style {
    fn default() -> Self {
        Self {
            color: Rgb888::BLACK,
            fill: Ink::Color(Rgb888::BLACK),
            rule: FillRule::NonZero,
            stroke: Ink::None,
            width: 1.0,
            is_fixed: false,
            cap: Cap::Butt,
            join: Join::Miter,
            miter_limit: 4.0,
            dashes: vec![],
            phase: 0.0,
            is_visible: true,
            is_outline_first: false,
            measure: Measure { whole: [100.0, 100.0], em: EM },
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
        let view = root.attribute("viewBox").map(ViewBox::from_str);
        let is_wrong = matches!(view, Some(Err(_)));
        let view = view.and_then(Result::ok);
        let [width, height] = ["width", "height"].map(|name| {
            let length = Length::from_str(root.attribute(name)?).ok()?;
            Some(length.number * unit(length.unit)).filter(|n| length.unit != LengthUnit::Percent && *n > 0.0)
        });
        let size = match (view, width, height) {
            (_, Some(width), Some(height)) => [width, height],
            (Some(view), Some(width), None) => [width, width * view.h / view.w],
            (Some(view), None, Some(height)) => [height * view.w / view.h, height],
            (Some(view), None, None) => [view.w, view.h],
            (None, width, height) => [width.unwrap_or(100.0), height.unwrap_or(100.0)],
        };
        let view = view.map_or([0.0, 0.0, size[0], size[1]], |view| [view.x, view.y, view.w, view.h]);
        let mut unknown = BTreeSet::new();
        if is_wrong {
            unknown.insert("the attribute `viewBox`".into());
        }
        let texts = sheet::texts(&document);
        let sheet = sheet::rules(&texts, &mut unknown);
        let mut ids = HashMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                // Of several, the first one.
                ids.entry(id).or_insert(node);
            }
        }
        let mut reader = Reader { document: &document, marks: vec![], unknown, errors: vec![], sheet, ids, left: MOST };
        let measure = Measure { whole: [view[2], view[3]], em: EM };
        let style = Style { measure, ..Style::default() };
        reader.read(root, &style, Transform::default(), Depth::default());
        let Reader { marks, unknown, errors, .. } = reader;
        Ok(Self { marks, view, size, aspect: aspect(root.attribute("preserveAspectRatio")), unknown, errors })
    }

    /// The pixels that it asks for, from 1 to 4096 in each direction.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is clamped")]
    pub fn size(&self) -> (u16, u16) {
        let [width, height] = self.size.map(|n| n.round().clamp(1.0, 4096.0) as u16);
        (width, height)
    }

    /// The path data of its shapes, as SVG has it: that of basic shapes is made here.
    pub fn data(&self) -> impl Iterator<Item = &str> {
        self.marks.iter().map(|mark| &*mark.data)
    }

    /// Its shapes on a screen of this size, in the middle and as large as they fit, and then mapped by the six numbers that SVG
    /// calls `matrix`. What turns out to be unknown is added to the rest of it.
    pub fn shapes(&mut self, (width, height): (u16, u16), then: [f64; 6], min_width: I24F8) -> Vec<Shape> {
        let fit = fit(self.view, [f64::from(width), f64::from(height)], self.aspect);
        let [a, b, c, d, e, f] = then;
        let fit = product(Transform::new(a, b, c, d, e, f), fit);
        let mut shapes = vec![];
        for mark in &self.marks {
            let map = product(fit, mark.map);
            let path = segments(&mark.data, map);
            let (fill, stroke) = (mark.style.fill.color(mark.style.color), mark.style.stroke.color(mark.style.color));
            let grows = if mark.style.is_fixed { 1.0 } else { (map.a * map.d - map.b * map.c).abs().sqrt() };
            let even = (map.a - map.d).hypot(map.b + map.c).min((map.a + map.d).hypot(map.b - map.c));
            if stroke.is_some() && !mark.style.is_fixed && even > 1e-3 * grows {
                self.unknown.insert("outlines that are wider in one direction than in the other".into());
            }
            let length = |n: f64| I24F8::saturating_from_num(finite(n * grows));
            let outline = stroke.filter(|_| mark.style.width > 0.0).map(|color| Outline {
                stroke: Stroke::new(length(mark.style.width))
                    .with_cap(mark.style.cap)
                    .with_join(mark.style.join)
                    .with_miter_limit(I24F8::saturating_from_num(finite(mark.style.miter_limit)))
                    .with_min_width(min_width),
                dashes: mark.style.dashes.iter().map(|&n| length(n)).collect(),
                phase: length(mark.style.phase),
                color,
            });
            let fill = fill.map(|color| (mark.style.rule, color));
            if mark.style.is_outline_first {
                shapes.push(Shape { path: path.clone(), fill: None, drop_out: None, outline });
                shapes.push(Shape { path, fill, drop_out: None, outline: None });
            } else {
                shapes.push(Shape { path, fill, drop_out: None, outline });
            }
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

/// A part of the plane on an area of this size, whose corner is (0, 0).
fn fit([left, top, wide, high]: [f64; 4], size: [f64; 2], aspect: AspectRatio) -> Transform {
    let [x, y] = [size[0] / wide, size[1] / high];
    let one = if aspect.slice { x.max(y) } else { x.min(y) };
    let [x, y] = if aspect.align == Align::None { [x, y] } else { [one, one] };
    // Where the rest lies: half before it, unless told.
    let (before_x, before_y) = match aspect.align {
        Align::None | Align::XMinYMin => (0.0, 0.0),
        Align::XMidYMin => (0.5, 0.0),
        Align::XMaxYMin => (1.0, 0.0),
        Align::XMinYMid => (0.0, 0.5),
        Align::XMidYMid => (0.5, 0.5),
        Align::XMaxYMid => (1.0, 0.5),
        Align::XMinYMax => (0.0, 1.0),
        Align::XMidYMax => (0.5, 1.0),
        Align::XMaxYMax => (1.0, 1.0),
    };
    let (rest_x, rest_y) = (size[0] - x * wide, size[1] - y * high);
    Transform::new(x, 0.0, 0.0, y, before_x * rest_x - x * left, before_y * rest_y - y * top)
}

fn aspect(text: Option<&str>) -> AspectRatio {
    text.and_then(|text| AspectRatio::from_str(text).ok()).unwrap_or_default()
}

/// A number that is one: 0 in place of what a quotient by 0 makes.
fn finite(n: f64) -> f64 {
    if n.is_nan() {
        0.0
    } else {
        n
    }
}

/// Path data, which is right, as it is on the screen.
fn segments(data: &str, map: Transform) -> Vec<PathSegment> {
    let (data, map) = numbers::fitted(data, map);
    let number = |n: f64| I16F16::saturating_from_num(finite(n));
    let map = Affine {
        xx: number(map.a),
        xy: number(map.c),
        dx: number(map.e),
        yx: number(map.b),
        yy: number(map.d),
        dy: number(map.f),
    };
    Path::svg(&data).map(|path| path.mapped(map).collect()).unwrap_or_default()
}

/// The start of path data, as far as it makes sense, and what comes then.
fn right_part(data: &str) -> (&str, Option<SvgError>) {
    let (mut right, mut first) = (data, None);
    while let Err(error) = Path::svg(right) {
        right = &right[..error.position];
        right = &right[..right.rfind(|c: char| c.is_ascii_alphabetic()).unwrap_or(0)];
        first = first.or(Some(error));
    }
    (right, first)
}

/// The size of a font, unless told.
const EM: f64 = 16.0;

/// Pixels of a unit, where the font has its usual size.
fn unit(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em => EM,
        LengthUnit::Pc => 16.0,
        LengthUnit::Ex => EM / 2.0,
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

/// How deep an element lies in others, and in uses of others.
#[derive(Copy, Clone, Debug, Default)]
struct Depth {
    elements: usize,
    uses: usize,
}

impl Depth {
    fn more(self) -> Self {
        Self { elements: self.elements + 1, ..self }
    }
}

/// The first child of a `switch` that asks for nothing that is not here, in English.
fn first_plain<'a, 'input>(switch: Node<'a, 'input>) -> Option<Node<'a, 'input>> {
    let speaks = |list: &str| list.split(',').any(|one| one.trim().split('-').next() == Some("en"));
    switch.children().find(|node| {
        node.is_element()
            && !node.has_attribute("requiredExtensions")
            && node.attribute("systemLanguage").is_none_or(speaks)
    })
}

/// Goes over a document.
struct Reader<'a, 'input> {
    document: &'a Document<'input>,
    marks: Vec<Mark>,
    unknown: BTreeSet<String>,
    errors: Vec<String>,
    sheet: StyleSheet<'a>,
    ids: HashMap<&'a str, Node<'a, 'input>>,
    /// What is left of [`MOST`].
    left: usize,
}

impl<'a, 'input: 'a> Reader<'a, 'input> {
    /// All that is said of a node: attributes, then the style sheet, then its own style; what is important is said last.
    fn said(&self, node: Node<'a, 'input>) -> BTreeMap<String, String> {
        // Attributes with a prefix are notes of other programs.
        let attributes = node.attributes().filter(|attribute| attribute.namespace().is_none());
        let mut all: BTreeMap<String, String> =
            attributes.map(|attribute| (attribute.name().into(), attribute.value().into())).collect();
        let own = DeclarationTokenizer::from(node.attribute("style").unwrap_or_default());
        let rules = self.sheet.rules.iter().filter(|rule| rule.selector.matches(&Styled(node)));
        let said: Vec<_> = rules.flat_map(|rule| &rule.declarations).copied().chain(own).collect();
        for is_important in [false, true] {
            let these = said.iter().filter(|declaration| declaration.important == is_important);
            all.extend(these.map(|declaration| (declaration.name.into(), declaration.value.into())));
        }
        all
    }

    fn read(&mut self, node: Node<'a, 'input>, inherited: &Style, map: Transform, depth: Depth) {
        if self.left < ELEMENT {
            self.unknown.insert(format!("what comes after {MOST} bytes of paths"));
            return;
        }
        self.left -= ELEMENT;
        let name = node.tag_name().name();
        let said = self.said(node);
        let get = |name: &str| said.get(name).map(String::as_str);
        if get("display") == Some("none") || get("opacity").and_then(share) == Some(0.0) {
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
        self.name_what_is_left_out(name, &said, style.measure);
        match name {
            "svg" if depth.elements > 0 => self.area(node, &said, style, map, depth),
            "svg" | "g" | "a" => self.children(node, &style, map, depth),
            "switch" => {
                if let Some(child) = first_plain(node) {
                    self.read(child, &style, map, depth.more());
                }
            }
            "use" => self.used(node, &said, &style, map, depth),
            // Symbols are drawn where they are used.
            "symbol" | "defs" | "title" | "desc" | "metadata" | "style" | "namedview" | "script" | "linearGradient"
            | "radialGradient" | "clipPath" | "mask" | "filter" | "marker" | "pattern" | "SVGTestCase" => {}
            _ => match data(name, &said, style.measure) {
                Some(data) if style.is_visible => self.mark(node, &data, map, style),
                Some(_) => {}
                None => {
                    self.unknown.insert(format!("the element `{name}`"));
                }
            },
        }
    }

    /// Names attributes that are not followed.
    fn name_what_is_left_out(&mut self, name: &str, said: &BTreeMap<String, String>, measure: Measure) {
        let get = |name: &str| said.get(name).map(String::as_str);
        for what in LEFT_OUT {
            if get(what).is_some_and(|value| !matches!(value, "none" | "normal")) {
                self.unknown.insert(format!("the attribute `{what}`"));
            }
        }
        for text in LENGTHS.iter().filter_map(|what| get(what)).filter(|_| MEASURED.contains(&name)) {
            if text != "auto" && length(text, 2, measure).is_none() {
                self.unknown.insert(format!("the length `{text}`"));
            }
        }
    }

    /// What a `use` refers to.
    fn used(
        &mut self,
        node: Node<'a, 'input>,
        said: &BTreeMap<String, String>,
        style: &Style,
        map: Transform,
        depth: Depth,
    ) {
        let get = |name: &str| said.get(name).map(String::as_str);
        let href = node.attributes().find(|attribute| attribute.name() == "href").map(|a| a.value());
        let id = href.and_then(|href| href.strip_prefix('#'));
        if href.is_some() && id.is_none() {
            self.unknown.insert("a `use` of another file".into());
            return;
        }
        let target = id.and_then(|id| self.ids.get(id).copied());
        let Some(target) = target.filter(|_| depth.uses < DEPTH) else {
            self.unknown.insert("a `use` of something that is not there".into());
            return;
        };
        let at = |name: &str, axis| get(name).and_then(|text| length(text, axis, style.measure)).unwrap_or(0.0);
        let map = product(map, Transform::new(1.0, 0.0, 0.0, 1.0, at("x", 0), at("y", 1)));
        let depth = Depth { uses: depth.uses + 1, ..depth.more() };
        match target.tag_name().name() {
            "symbol" | "svg" => {
                // Its size is that of the use, if that has one.
                let mut of = self.said(target);
                of.extend(["width", "height"].iter().filter_map(|&name| Some((name.into(), get(name)?.into()))));
                let style = self.style(&of, style);
                self.area(target, &of, style, map, depth);
            }
            _ => self.read(target, style, map, depth),
        }
    }

    fn children(&mut self, node: Node<'a, 'input>, style: &Style, map: Transform, depth: Depth) {
        if depth.elements >= NESTED {
            self.unknown.insert(format!("what lies in {NESTED} elements and more"));
            return;
        }
        for child in node.children().filter(Node::is_element) {
            self.read(child, style, map, depth.more());
        }
    }

    /// The inside of an `svg` in another one, or of a `symbol` in use: a part of the plane on an area of this one.
    fn area(
        &mut self,
        node: Node<'a, 'input>,
        said: &BTreeMap<String, String>,
        mut style: Style,
        map: Transform,
        depth: Depth,
    ) {
        let number = |name, axis| said.get(name).and_then(|text| length(text, axis, style.measure));
        let [x, y] = [("x", 0), ("y", 1)].map(|(name, axis)| number(name, axis).unwrap_or(0.0));
        let size =
            [("width", 0), ("height", 1)].map(|(name, axis)| number(name, axis).unwrap_or(style.measure.whole[axis]));
        if size.iter().any(|&side| side <= 0.0) {
            return;
        }
        let mut map = product(map, Transform::new(1.0, 0.0, 0.0, 1.0, x, y));
        let (area, first) = (map, self.marks.len());
        style.measure.whole = size;
        if let Some(Ok(view)) = said.get("viewBox").map(|text| ViewBox::from_str(text)) {
            let aspect = aspect(said.get("preserveAspectRatio").map(String::as_str));
            map = product(map, fit([view.x, view.y, view.w, view.h], size, aspect));
            style.measure.whole = [view.w, view.h];
        }
        self.children(node, &style, map, depth);
        let is_open = said.get("overflow").is_some_and(|value| matches!(&value[..], "visible" | "auto"));
        if !is_open && self.marks[first..].iter().any(|mark| mark.leaves(area, size)) {
            self.unknown.insert(format!("what lies beyond the area of a `{}`", node.tag_name().name()));
        }
    }

    fn mark(&mut self, node: Node<'a, 'input>, data: &str, map: Transform, style: Style) {
        self.left = self.left.saturating_sub(data.len());
        for child in node.children().filter(Node::is_element) {
            let name = child.tag_name().name();
            if name == "set" || name.starts_with("animate") {
                self.unknown.insert(format!("the element `{name}`"));
            }
        }
        let (right, wrong) = right_part(data);
        if let Some(error) = wrong {
            let line = self.document.text_pos_at(node.range().start).row;
            let error = format!("line {line}: path data: {error}");
            if !self.errors.contains(&error) {
                self.errors.push(error);
            }
        }
        self.marks.push(Mark { data: right.into(), map, style });
    }

    /// What a node makes of the style that it inherits.
    fn style(&mut self, said: &BTreeMap<String, String>, inherited: &Style) -> Style {
        let mut style = inherited.clone();
        let get = |name: &str| said.get(name).map(String::as_str).filter(|value| *value != "inherit");
        if let Some(Ok(color)) = get("color").map(Color::from_str) {
            style.color = rgb(color);
        }
        if get("color").map(Color::from_str).is_some_and(|color| color.is_ok_and(|color| color.alpha < u8::MAX)) {
            self.unknown.insert("colours that let something through".into());
        }
        if let Some(text) = get("font-size") {
            match font_size(text, style.measure.em) {
                Some(em) => style.measure.em = em,
                None => _ = self.unknown.insert(format!("the length `{text}`")),
            }
        }
        if let Some(text) = get("paint-order") {
            style.is_outline_first = text.trim_start().starts_with("stroke");
        }
        style.fill = self.paint(get("fill"), style.fill);
        style.stroke = self.paint(get("stroke"), style.stroke);
        for (name, paint) in [("fill-opacity", &mut style.fill), ("stroke-opacity", &mut style.stroke)] {
            match get(name).and_then(share) {
                Some(0.0) => *paint = Ink::None,
                Some(n) if n < 1.0 => _ = self.unknown.insert(format!("the attribute `{name}`")),
                _ => {}
            }
        }
        if get("opacity").and_then(share).is_some_and(|n| n < 1.0) {
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
        let measure = style.measure;
        for text in ["stroke-width", "stroke-dashoffset"].into_iter().filter_map(get) {
            if length(text, 2, measure).is_none() {
                self.unknown.insert(format!("the length `{text}`"));
            }
        }
        let number = |name: &str| get(name).and_then(|text| length(text, 2, measure));
        style.width = number("stroke-width").filter(|n| *n >= 0.0).unwrap_or(style.width);
        style.miter_limit = number("stroke-miterlimit").filter(|n| *n >= 1.0).unwrap_or(style.miter_limit);
        style.phase = number("stroke-dashoffset").unwrap_or(style.phase);
        style.is_fixed = get("vector-effect") == Some("non-scaling-stroke");
        if let Some(text) = get("stroke-dasharray") {
            let lengths: Result<Vec<Length>, _> = LengthListParser::from(text).collect();
            if lengths.is_err() && text != "none" {
                self.unknown.insert(format!("the lengths `{text}`"));
            }
            let lengths = lengths.unwrap_or_default().into_iter().map(|length| units(length, 2, measure));
            style.dashes = lengths.collect();
            // A length below 0 is an error, and the outline solid.
            if style.dashes.iter().sum::<f64>() <= 0.0 || style.dashes.iter().any(|&length| length < 0.0) {
                style.dashes.clear();
            }
        }
        if !style.dashes.is_empty() && said.contains_key("pathLength") {
            self.unknown.insert("the attribute `pathLength`".into());
        }
        match get("visibility") {
            Some("hidden" | "collapse") => style.is_visible = false,
            Some("visible") => style.is_visible = true,
            _ => {}
        }
        style
    }

    fn paint(&mut self, text: Option<&str>, inherited: Ink) -> Ink {
        match text.map(Paint::from_str) {
            Some(Ok(Paint::None)) => Ink::None,
            Some(Ok(Paint::CurrentColor)) => Ink::Current,
            Some(Ok(Paint::Color(color))) if color.alpha == 0 => Ink::None,
            Some(Ok(Paint::Color(color))) => {
                if color.alpha < u8::MAX {
                    self.unknown.insert("colours that let something through".into());
                }
                Ink::Color(rgb(color))
            }
            Some(Ok(Paint::FuncIRI(id, otherwise))) => {
                self.unknown.insert("gradients and patterns".into());
                match (self.first_stop(id, 0), otherwise) {
                    (Some(color), _) => Ink::Color(color),
                    (None, Some(PaintFallback::None)) => Ink::None,
                    (None, Some(PaintFallback::CurrentColor)) => Ink::Current,
                    (None, Some(PaintFallback::Color(color))) => Ink::Color(rgb(color)),
                    (None, None) => Ink::Color(Rgb888::new(128, 128, 128)),
                }
            }
            None | Some(Ok(Paint::Inherit | Paint::ContextFill | Paint::ContextStroke)) => inherited,
            Some(Err(_)) => {
                self.unknown.insert(format!("the colour `{}`", text.unwrap_or_default()));
                inherited
            }
        }
    }

    /// The first colour of a gradient, or of the one that it refers to.
    fn first_stop(&self, id: &str, depth: usize) -> Option<Rgb888> {
        let gradient = self.ids.get(id)?;
        let Some(stop) = gradient.children().find(|node| node.tag_name().name() == "stop") else {
            let href = gradient.attributes().find(|attribute| attribute.name() == "href")?.value();
            return if depth < DEPTH { self.first_stop(href.strip_prefix('#')?, depth + 1) } else { None };
        };
        let said = self.said(stop);
        Color::from_str(said.get("stop-color")?).ok().map(rgb)
    }
}

impl Mark {
    /// Whether it is drawn beyond an area of this size, whose corner a map moves from (0, 0). A curve counts with its control points.
    fn leaves(&self, area: Transform, size: [f64; 2]) -> bool {
        let determinant = area.a * area.d - area.b * area.c;
        if !determinant.is_normal() {
            return false;
        }
        let [a, b, c, d] = [area.d, -area.b, -area.c, area.a].map(|n| n / determinant);
        let back = Transform::new(a, b, c, d, -(a * area.e + c * area.f), -(b * area.e + d * area.f));
        // In thousandths of the area, and within one of them.
        let map = product(Transform::new(1e3 / size[0], 0.0, 0.0, 1e3 / size[1], 0.0, 0.0), product(back, self.map));
        let half = if matches!(self.style.stroke, Ink::None) { 0.0 } else { self.style.width / 2.0 };
        let [x, y] = [half * map.a.hypot(map.c), half * map.b.hypot(map.d)];
        let is_out = |at: PointFx| {
            let beyond = |n: f64, more: f64| n - more < -1.0 || n + more > 1_001.0;
            beyond(at.x.to_num(), x) || beyond(at.y.to_num(), y)
        };
        segments(&self.data, map).iter().any(|segment| match *segment {
            PathSegment::MoveTo(a) | PathSegment::LineTo(a) => is_out(a),
            PathSegment::QuadraticTo(a, b) => is_out(a) || is_out(b),
            PathSegment::CubicTo(a, b, c) => is_out(a) || is_out(b) || is_out(c),
            PathSegment::Close => false,
        })
    }
}

/// A number from 0 to 1, or per cents.
fn share(text: &str) -> Option<f64> {
    let text = text.trim();
    match text.strip_suffix('%') {
        Some(text) => text.parse::<f64>().ok().map(|n| n / 100.0),
        None => text.parse().ok(),
    }
}

/// A size of a font, in one of another size.
fn font_size(text: &str, em: f64) -> Option<f64> {
    Some(match text.trim() {
        "xx-small" => 9.0,
        "x-small" => 10.0,
        "small" => 13.0,
        "medium" => EM,
        "large" => 18.0,
        "x-large" => 24.0,
        "xx-large" => 32.0,
        "smaller" => em / 1.2,
        "larger" => em * 1.2,
        text => length(text, 2, Measure { whole: [em, em], em })?,
    })
}

/// A length in the units of the file; of a per cent, the share of the width, of the height, or of a mean of both.
fn length(text: &str, axis: usize, measure: Measure) -> Option<f64> {
    let length = Length::from_str(text.trim()).ok()?;
    Some(units(length, axis, measure))
}

fn units(length: Length, axis: usize, Measure { whole, em }: Measure) -> f64 {
    let of = match (length.unit, axis) {
        (LengthUnit::Em | LengthUnit::Ex, _) => em / EM,
        (LengthUnit::Percent, 0 | 1) => whole[axis],
        (LengthUnit::Percent, _) => whole[0].hypot(whole[1]) / 2_f64.sqrt(),
        _ => 1.0,
    };
    length.number * unit(length.unit) * of
}

/// The path data of a shape; `None` if it is none.
fn data(name: &str, said: &BTreeMap<String, String>, measure: Measure) -> Option<String> {
    let number = |name: &str, axis: usize| said.get(name).and_then(|text| length(text, axis, measure));
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
        "path" => said.get("d").filter(|data| data.trim() != "none").cloned().unwrap_or_default(),
        "circle" => {
            let r = number("r", 2).unwrap_or(0.0);
            ellipse(r, r)
        }
        "ellipse" => {
            // One alone stands for both.
            let (rx, ry) = (number("rx", 0), number("ry", 1));
            ellipse(rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0))
        }
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
        assert_eq!(unknown("<g fill='rgba(0,0,0,.5)'/>"), "colours that let something through");
        assert_eq!(unknown("<path d='M2 2h9' stroke-dasharray='1' pathLength='4'/>"), "the attribute `pathLength`");
        let at_rule = "<style>@media print { path { fill: red } }</style>";
        assert_eq!(unknown(at_rule), "rules of style sheets that begin with `@`");
        assert_eq!(unknown("<style>path:{</style>"), "the style sheet `path:{`");
        assert_eq!(unknown("<use href='other.svg#a'/>"), "a `use` of another file");
        assert_eq!(unknown("<rect width='calc(1px + 2px)' height='4'/>"), "the length `calc(1px + 2px)`");
        assert_eq!(unknown("<path d='M0 0h5' stroke-width='2rem'/>"), "the length `2rem`");
        assert_eq!(unknown("<path d='M0 0h5' stroke-dasharray='2 x'/>"), "the lengths `2 x`");
        assert_eq!(unknown("<path d='M0 0h5' opacity='50%'/>"), "the attribute `opacity`");
        assert_eq!(unknown("<g style='mix-blend-mode: multiply'/>"), "the attribute `mix-blend-mode`");
        assert_eq!(unknown("<circle r='4'><animate attributeName='r'/></circle>"), "the element `animate`");
        assert_eq!(unknown("<g color='#0008'/>"), "colours that let something through");
        let area = |inside: &str| unknown(&format!("<svg x='2' width='9' height='9' viewBox='0 0 2 2'>{inside}</svg>"));
        assert_eq!(area("<path d='M0 0h2v2h-2z'/><circle cx='1' cy='1' r='1'/>"), "");
        assert_eq!(area("<path d='M0 0h2v3h-2z'/>"), "what lies beyond the area of a `svg`");
        assert_eq!(area("<path d='M0 0h2v2h-2z' stroke='red'/>"), "what lies beyond the area of a `svg`");
        assert!(File::parse("<html/>").is_err_and(|error| error == "`html` is no SVG"));
        assert!(File::parse("<svg").is_err_and(|error| !error.contains('\n')));
        let dark =
            "<style>@import 'x'; path { fill: red } @media (dark) { g { fill: red } path { fill: none } }</style>";
        let (pixels, unknown) = drawn(&format!("{dark}<path d='M2 2h5v5z'/>"));
        assert_eq!((pixels.len(), &unknown.join("; ")[..]), (15, "rules of style sheets that begin with `@`"));
        let circle = "<g id='a'><use href='#a'/></g>";
        assert_eq!(drawn(circle).1, ["a `use` of something that is not there"], "a circle of references ends");
    }

    #[test]
    fn data_is_drawn_as_far_as_it_makes_sense() {
        let text = "<svg viewBox='0 0 20 20'>\n<path d='M2 2h5v5L9 x'/><path d='none'/>\n<path d='L2 2'/></svg>";
        let mut file = File::parse(text).expect("an SVG file");
        let errors = [
            "line 2: path data: position 11: a number is expected",
            "line 3: path data: position 0: a path begins with M",
        ];
        assert_eq!(file.errors, errors);
        let shapes = file.shapes(SIZE, [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO);
        assert_eq!(shapes.iter().map(|shape| shape.path.len()).collect::<Vec<_>>(), [3, 0, 0]);
    }

    const SQUARE: &str = "<path d='M5 5h5v5h-5z'/>";

    #[test]
    fn parts_of_the_plane_lie_on_areas() {
        // Half as large in an area of 10 x 10 pixels, from 5, 5 on.
        for inner in [
            "<svg x='5' y='5' width='10' height='10' viewBox='0 0 20 20'><path d='M0 0h10v10h-10z'/></svg>",
            "<svg x='25%' y='25%' width='50%' height='50%' viewBox='0 0 40 40'><rect width='50%' height='50%'/></svg>",
            "<defs><symbol id='s' viewBox='10 10 20 20'><path d='M10 10h10v10h-10z'/></symbol></defs>
             <use href='#s' x='25%' y='5' width='10' height='10'/>",
            "<symbol id='s'><rect width='5' height='5'/></symbol><use href='#s' x='5' y='5'/>",
            // In an area that is wider, in the middle, at its start and its end; without a margin; and one that is filled.
            "<svg y='5' width='20' height='10' viewBox='0 0 2 2'><path d='M0 0h1v1h-1z'/></svg>",
            "<svg x='5' y='5' width='15' height='10' viewBox='0 0 2 2' preserveAspectRatio='xMinYMin'><path d='M0 0h1v1h-1z'/></svg>",
            "<svg x='-5' y='5' width='20' height='10' viewBox='0 0 2 2' preserveAspectRatio='xMaxYMax'><path d='M0 0h1v1h-1z'/></svg>",
            "<svg x='5' y='5' width='10' height='5' viewBox='0 0 2 1' preserveAspectRatio='none'><path d='M0 0h1v1h-1z'/></svg>",
            "<svg x='5' y='5' width='5' height='2' viewBox='0 0 5 5' preserveAspectRatio='xMinYMin slice' overflow='visible'><rect width='5' height='5'/></svg>",
        ] {
            same(inner, SQUARE);
        }
        let text = "<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='none'><path d='M0 0h10v10h-10z'/></svg>";
        let mut file = File::parse(text).expect("an SVG file");
        let shapes = file.shapes((40, 20), [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO);
        assert_eq!(shapes[0].path[2], PathSegment::LineTo(embedded_raster::PointFx::px(40, 20)), "the root, too");
    }

    #[test]
    fn lengths_are_those_of_their_unit() {
        let text = "<svg width='40' height='20'><rect x='50%' y='50%' width='1.5pt' height='10%' ry='0'/></svg>";
        let file = File::parse(text).expect("an SVG file");
        assert_eq!(file.data().next(), Some("M20.000000000 10.000000000h2.000000000v2.000000000h-2.000000000z"));
        let dashed =
            |dashes: &str| format!("<path d='M0 10h20' stroke='red' stroke-width='2' stroke-dasharray='{dashes}'/>");
        same(&dashed("10%"), &dashed("2"));
        same(&dashed("4 -2"), &dashed("none"));
        same("<g font-size='4'><rect width='2em' height='1ex'/></g>", "<rect width='8' height='2'/>");
        same(
            "<g font-size='200%'><rect width='.5em' height='1em' font-size='.25em'/></g>",
            "<rect width='4' height='8'/>",
        );
        same("<ellipse cx='9' cy='9' rx='7'/>", "<circle cx='9' cy='9' r='7'/>");
        same(
            "<path d='M2 4h4' transform='scale(2.5)' stroke='red' vector-effect='non-scaling-stroke' stroke-width='4'/>",
            "<path d='M5 10h10' stroke='red' stroke-width='4'/>",
        );
    }

    #[test]
    fn style_sheets_count_by_weight_and_order() {
        let styled =
            |sheet: &str| format!("<style>{sheet}</style><path id='i' class='a b' d='M5 5h5v5h-5z'/><circle r='5'/>");
        for sheet in [
            "circle { fill: none }",
            "/* a { */ circle, g { fill: none } /* } */",
            "<![CDATA[ circle { fill: none } ]]>",
            "* { fill: none } #i { fill: red }",
            "#i { fill: red } * { fill: none }",
            ".b { fill: none } .a { fill: red } circle { fill: none }",
            "svg > circle { fill: none } g > path { fill: none }",
            "path + circle { fill: none }",
            "path.b.a { fill: red } .b { fill: none } circle { fill: none }",
            ".b { fill: red !important } #i { fill: none } circle { fill: none }",
        ] {
            same(&styled(sheet), SQUARE);
        }
        same("<g fill='currentColor' color='none'><path color='red' d='M5 5h5v5h-5z'/></g>", SQUARE);
        let marked = "<path xmlns:x='urn:x' x:d='M0 0h9v9' x:fill='none' x:transform='scale(3)' d='M5 5h5v5h-5z'/>";
        same(marked, SQUARE);
        same(
            "<switch><circle r='9' systemLanguage='de, fr'/><path d='M5 5h5v5h-5z' systemLanguage='de, en-GB'/></switch>",
            SQUARE,
        );
        same(
            "<switch><g requiredExtensions='x'><circle r='9'/></g><path d='M5 5h5v5h-5z'/><circle r='9'/></switch>",
            SQUARE,
        );
        same("<linearGradient id='a' href='#b'/><path d='M5 5h5v5h-5z' fill='red'/>", SQUARE);
    }

    /// Numbers of 16.16 are too few for maps of the world in metres, and for view boxes that are much larger than the screen.
    #[test]
    fn large_and_small_units_are_as_good() {
        let path = "M5 5C6 1 13 2 15 5s-3.5 6-1 9q4 2-1 3t-6-2A5 3 20 0 1 4 11z";
        let stroke = "stroke='red' stroke-width='1.5'";
        let expected = drawn(&format!("<path d='{path}' {stroke}/>")).0;
        for (scale, x, y) in [(1e5, 0.0, 0.0), (3e-4, 0.0, 0.0), (1.0, 5e5, -6e6), (700.0, 1e7, 2e7), (1e-3, 8e3, -3e3)]
        {
            let map = Transform::new(scale, 0.0, 0.0, scale, x, y);
            let data = numbers::scaled(path, scale, (-x / scale, -y / scale));
            let text = format!(
                "<svg viewBox='{x} {y} {0} {0}'><path d='{data}' stroke='red' stroke-width='{1}'/></svg>",
                20.0 * map.a,
                1.5 * map.a
            );
            let mut file = File::parse(&text).expect("an SVG file");
            let shapes = file.shapes(SIZE, [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO);
            let screen = Screen { width: 20, height: 20, bits: 24, band: 20, slots: 999, paper: Rgb888::WHITE };
            let picture = draw(&shapes, &screen).expect("enough slots").picture;
            let all = (0..20).flat_map(|y| (0..20).map(move |x| [x, y]));
            let pixels: Vec<_> = all.filter(|&[x, y]| picture.color(x, y) != Some(Rgb888::WHITE)).collect();
            let differing = pixels.iter().filter(|at| !expected.contains(at)).count()
                + expected.iter().filter(|at| !pixels.contains(at)).count();
            assert!(differing <= 1, "{differing} pixels differ, units of {scale}, from {x}, {y}");
        }
    }

    #[test]
    fn files_that_are_not_meant_well_end() {
        let nested = |n: usize| format!("{}{SQUARE}{}", "<g>".repeat(n), "</g>".repeat(n));
        same(&nested(100), SQUARE);
        same(
            &format!("<defs><g id='s'>{SQUARE}</g></defs>{}<use href='#s'/>{}", "<g>".repeat(40), "</g>".repeat(40)),
            SQUARE,
        );
        assert_eq!(drawn(&nested(600)).1, ["what lies in 512 elements and more"]);
        let mut many = format!("<defs><g id='u0'>{SQUARE}</g>");
        for i in 1..16 {
            let uses = format!("<use href='#u{}'/>", i - 1).repeat(9);
            many.extend(["<g id='u", &i.to_string(), "'>", &uses, "</g>"]);
        }
        let text = format!("<svg>{many}</defs><use href='#u15'/></svg>");
        assert!(File::parse(&text).expect("an SVG file").unknown.contains("what comes after 67108864 bytes of paths"));
        for root in [
            "width='0' height='0'",
            "width='-4' height='3e99'",
            "viewBox='0 0 0 0'",
            "viewBox='0 0 1e-300 1e300'",
            "viewBox='1e300 0 3 3'",
        ] {
            let text = format!("<svg {root}><g transform='scale(1e300) scale(1e300 0)'>{SQUARE}</g><path stroke='red' d='M1 1h1e30'/></svg>");
            let mut file = File::parse(&text).expect("an SVG file");
            let size = file.size();
            assert!(!file.shapes(size, [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO).is_empty(), "{root}");
        }
    }
}
