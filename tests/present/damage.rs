//! Damage: no pixel that changes is missing in it, from whatever call, in whatever capacity; and what is drawn and sent by it alone is the
//! same as all of it.

use std::num::NonZeroU32;

use calls::Arguments;
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
use embedded_raster::{
    pixel::{Lsb0, Rgb444},
    present::{Buffer, Grain, History, Queues, Swapchain},
    surface::{Counter, Damage, Grid, Packed12, Pages, Planes, Recorder, Rows},
    Canvas, Frame, Index1, Index2, Index4, Layout, PixelFormat, Rect, Surface,
};
use twins::{
    arguments::{Ground, Scratch},
    input::{Input, EXTREMES},
    memory::{color, pixels},
    rng::{cases, Rng},
    ALL_LAYOUTS,
};

const WIDTH: u16 = 41;
const HEIGHT: u16 = 29;
const SCREEN: Rect = Rect::new(0, 0, 41, 29);

fn open<L: Layout>(memory: &mut [u8]) -> Frame<&mut [u8], L> {
    Frame::new(memory, WIDTH, HEIGHT).expect("the right size")
}

fn bytes<L: Layout>() -> usize {
    L::bytes(WIDTH, Grid { stride: L::row_bytes(WIDTH), rows: HEIGHT.into() })
}

/// Pixels of a window that two memories do not have in common.
fn changed<L: Layout>(a: &mut [u8], b: &mut [u8], window: Rect) -> Vec<(i32, i32)> {
    let (a, b): (Vec<_>, Vec<_>) = (open::<L>(a).colors(window).collect(), open::<L>(b).colors(window).collect());
    pixels(window).zip(a.into_iter().zip(b)).filter(|(_, (a, b))| a != b).map(|(at, _)| at).collect()
}

fn holds(areas: &[Rect], (x, y): (i32, i32)) -> bool {
    areas.iter().any(|area| area.contains(x, y))
}

/// A call on a recorder. What is recorded is not generic, as there are hundreds of calls.
fn recorded_call<L: Layout>(
    on: &mut Frame<&mut [u8], L>,
    record: &mut dyn FnMut(Rect),
    a: &mut Arguments<'_, L>,
    number: usize,
) -> usize {
    calls::call(&mut Recorder::new(on, record), a, number)
}

/// Every call on a recorder draws and answers as without, and tells where it draws.
fn every_call<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64) {
    let (mut rng, mut scratch) = (Rng::new(seed), Scratch::new(seed));
    for _ in 0..cases(250) {
        let bits: Vec<u8> = (0..1_200).map(|_| rng.bits() as u8).collect();
        let before: Vec<u8> = (0..bytes::<L>()).map(|_| rng.bits() as u8).collect();
        let clip = Rect::new(rng.int(-3, 12), rng.int(-3, 9), rng.int(20, 45), rng.int(15, 33));
        let window = clip.intersection(SCREEN);
        let ground = if rng.one_in(3) { Ground::Wild } else { Ground::Near(window) };
        let colors = [(); 2].map(|()| color::<F>(&mut rng));
        for number in 0..calls::COUNT {
            let (mut plain, mut recorded) = (before.clone(), before.clone());
            let name = calls::DRAWING.iter().chain(calls::READING).nth(number).expect("a name");
            let answer = {
                let a = &mut scratch.arguments::<L>(&mut Input(&bits), ground, colors);
                calls::call(&mut open::<L>(&mut plain).clipped(clip), a, number)
            };
            let (mut told, mut damage) = (vec![], Damage::<2>::new());
            let mut record = |area: Rect| {
                assert!(!area.is_empty() && area.intersection(window) == area, "{name} in {window:?}: {area:?}");
                told.push(area);
                damage.add(area);
            };
            let a = &mut scratch.arguments::<L>(&mut Input(&bits), ground, colors);
            let same = recorded_call(&mut open::<L>(&mut recorded).clipped(clip), &mut record, a, number);
            assert!(plain == recorded && answer == same, "{name} draws as without a recorder");
            for at in changed::<L>(&mut before.clone(), &mut recorded, window) {
                assert!(holds(&told, at), "{name} changed {at:?} and told {told:?}");
                assert!(holds(damage.areas(), at), "{name} changed {at:?}, and {damage:?}");
            }
        }
    }
}

#[test]
fn every_call_is_recorded() {
    every_call::<Index4, Rows<Index4>>(1500);
    if ALL_LAYOUTS {
        every_call::<Rgb565, Rows<Rgb565>>(1501);
        every_call::<BinaryColor, Pages<Lsb0<BinaryColor>>>(1502);
    }
}

/// Lines of every direction, on a screen that is large enough for many pieces.
#[test]
fn lines_are_recorded_in_pieces() {
    let mut rng = Rng::new(1505);
    let screen = Rect::new(0, 0, 320, 240);
    let (mut boxes, mut pieces) = (0, 0);
    for _ in 0..cases(3_000) {
        let mut end = || (rng.int(-300, 600), rng.int(-200, 400));
        let (from, to) = (end(), end());
        let mut memory = vec![0; 320 * 240 / 8];
        let mut frame = Frame::<_, Rows<Index1>>::new(&mut memory[..], 320, 240).expect("the right size");
        let mut told = vec![];
        Recorder::new(&mut frame, |area| told.push(area)).draw_line(from, to, Index1::new(1));
        for (at, color) in pixels(screen).zip(frame.colors(screen)) {
            assert!(color == Index1::new(0) || holds(&told, at), "{at:?} of {from:?} to {to:?}: {told:?}");
        }
        let area = |area: &Rect| area.width() * area.height();
        boxes += told.iter().copied().reduce(Rect::union).map_or(0, |all| area(&all));
        pieces += told.iter().map(area).sum::<u32>();
        assert!(told.len() <= 18, "{} pieces", told.len());
    }
    assert!(pieces * 4 < boxes, "{pieces} pixels in pieces, {boxes} in boxes");
}

/// The list by its rule, in wide numbers.
#[derive(Clone)]
struct Twin {
    capacity: usize,
    areas: Vec<Rect>,
    patience: u128,
}

fn size(area: Rect) -> u128 {
    u128::from(area.width().min(65_535)) * u128::from(area.height().min(65_535))
}

fn adds(a: Rect, b: Rect) -> u128 {
    size(a.union(b)).saturating_sub(size(a) + size(b))
}

impl Twin {
    fn new(capacity: usize) -> Self {
        Self { capacity, areas: vec![], patience: 32 }
    }

    fn add(&mut self, area: Rect) {
        if area.is_empty() {
            return;
        }
        if let Some(last) = self.areas.last_mut().filter(|last| adds(**last, area) <= self.patience) {
            *last = last.union(area);
            return;
        }
        self.areas.push(area);
        loop {
            // With the new one.
            let newest = self.areas.len() - 1;
            let cheapest = (0..newest).min_by_key(|&i| adds(self.areas[i], self.areas[newest]));
            if let Some(i) = cheapest.filter(|&i| adds(self.areas[i], self.areas[newest]) <= self.patience) {
                self.join(i, newest);
                continue;
            }
            if self.areas.len() <= self.capacity {
                return;
            }
            // Of all pairs.
            let pairs = (0..=newest).flat_map(|i| (i + 1..=newest).map(move |j| (i, j)));
            let (i, j) = pairs.min_by_key(|&(i, j)| adds(self.areas[i], self.areas[j])).expect("there are two");
            self.patience = self.patience.max(adds(self.areas[i], self.areas[j]));
            self.join(i, j);
        }
    }

    /// The joined one is the newest then.
    fn join(&mut self, i: usize, j: usize) {
        let later = self.areas.remove(j);
        let joined = self.areas.remove(i).union(later);
        self.areas.push(joined);
    }
}

fn sorted(areas: &[Rect]) -> Vec<(i32, i32, i32, i32)> {
    let mut areas: Vec<_> = areas.iter().map(|area| (area.x0, area.y0, area.x1, area.y1)).collect();
    areas.sort_unstable();
    areas
}

fn list<const N: usize>(seed: u64) {
    let mut rng = Rng::new(seed);
    let mut joined = 0;
    for _ in 0..cases(3_000) {
        let (mut damage, mut twin, mut added) = (Damage::<N>::new(), Twin::new(N), vec![]);
        let wild = rng.one_in(8);
        for _ in 0..rng.range(1, 24) {
            let mut side = |low, high| if wild { rng.pick(&EXTREMES) } else { rng.int(low, high) };
            let (x, y) = (side(0, 300), side(0, 200));
            let area = Rect::new(x, y, x.saturating_add(side(-1, 40)), y.saturating_add(side(-1, 30)));
            damage.add(area);
            twin.add(area);
            added.push(area);
            assert_eq!(damage.is_empty(), damage.areas().is_empty());
            assert!(damage.areas().len() <= N && damage.areas().iter().all(|area| !area.is_empty()), "{damage:?}");
            let bounds = added.iter().copied().reduce(Rect::union).expect("one at least");
            assert!(damage.bounds() == bounds || bounds.is_empty(), "all of them, and no more around");
            // Corners, and pixels inside.
            for area in added.iter().filter(|area| !area.is_empty()) {
                let [right, below] = [area.x1 - 1, area.y1 - 1];
                let middle = (i32::midpoint(area.x0, right), i32::midpoint(area.y0, below));
                for at in [(area.x0, area.y0), (right, area.y0), (area.x0, below), (right, below), middle] {
                    assert!(holds(damage.areas(), at), "{at:?} of {added:?} is not in {damage:?}");
                }
            }
        }
        // Where two pairs add as much, either is right.
        joined += usize::from(sorted(damage.areas()) == sorted(&twin.areas));
        let copy = damage.clone();
        assert_eq!(copy.areas(), damage.areas(), "a copy");
        let mut larger = Damage::<9>::new();
        larger.add_all(&damage);
        assert!(
            damage.areas().iter().all(|area| larger.areas().iter().any(|all| all.union(*area) == *all)),
            "{larger:?}"
        );
        damage.clear();
        assert!(damage.is_empty() && damage.bounds().is_empty(), "nothing has changed");
    }
    assert!(joined * 100 > cases(3_000) * 97, "{joined} times the same as the twin");
}

#[test]
fn a_list_of_any_capacity_holds_all() {
    list::<1>(1510);
    list::<2>(1511);
    list::<3>(1512);
    list::<5>(1513);
    list::<16>(1514);
}

/// Every pixel of the list alone, in small numbers: a list that loses pixels in the middle of a rectangle would not be found by its corners.
#[test]
fn a_list_holds_every_pixel() {
    let mut rng = Rng::new(1515);
    for _ in 0..cases(2_000) {
        let (mut damage, mut seen) = (Damage::<3>::new(), vec![false; 41 * 29]);
        for _ in 0..rng.range(1, 12) {
            let (x, y) = (rng.int(0, 40), rng.int(0, 28));
            let area = Rect::new(x, y, x + rng.int(0, 12), y + rng.int(0, 12)).intersection(SCREEN);
            damage.add(area);
            pixels(SCREEN).zip(&mut seen).for_each(|((x, y), seen)| *seen |= area.contains(x, y));
        }
        for (at, _) in pixels(SCREEN).zip(&seen).filter(|(_, seen)| **seen) {
            assert!(holds(damage.areas(), at), "{at:?}");
        }
    }
}

/// Grains, one by one.
#[test]
fn jobs_are_whole_grains_that_hold_all() {
    let mut rng = Rng::new(1520);
    for _ in 0..cases(4_000) {
        let screen = Rect::new(0, 0, rng.int(1, 60), rng.int(1, 50));
        let grain =
            rng.pick(&[(1, 1), (2, 1), (2, 2), (4, 1), (8, 1), (1, 8), (3, 5), (u16::MAX, 1), (0, 0), (7, u16::MAX)]);
        let (columns, rows) = (i32::from(grain.0.max(1)), i32::from(grain.1.max(1)));
        let mut damage = Damage::<4>::new();
        for _ in 0..rng.below(9) {
            let (x, y) = (rng.int(-9, 60), rng.int(-9, 50));
            damage.add(Rect::new(x, y, x + rng.int(0, 15), y + rng.int(0, 9)));
        }
        let jobs: Vec<Rect> = Grain::new(grain.0, grain.1).jobs(&damage, screen).collect();
        assert_eq!(Grain::new(grain.0, grain.1).jobs(&damage, screen).len(), jobs.len());
        assert!(
            jobs.windows(2).all(|pair| (pair[0].y0, pair[0].x0) <= (pair[1].y0, pair[1].x0)),
            "from the top: {jobs:?}"
        );
        for job in &jobs {
            assert!(!job.is_empty() && job.intersection(screen) == *job, "{job:?} on {screen:?}");
            assert!(
                job.x0 % columns == 0 && (job.x1 % columns == 0 || job.x1 == screen.x1),
                "{job:?}, {columns} columns"
            );
            assert!(job.y0 % rows == 0 && (job.y1 % rows == 0 || job.y1 == screen.y1), "{job:?}, {rows} rows");
        }
        for at in pixels(screen).filter(|&at| holds(damage.areas(), at)) {
            assert!(holds(&jobs, at), "{at:?} of {damage:?} is not in {jobs:?}");
        }
    }
}

#[test]
fn grains_of_any_numbers() {
    for x in EXTREMES {
        for y in EXTREMES {
            for (columns, rows) in [(1, 1), (2, 8), (0, u16::MAX)] {
                let (area, all) = (Rect::new(x, y, y, x), Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX));
                let around = Grain::new(columns, rows).around(area, all);
                assert!(
                    area.is_empty() == around.is_empty() && (area.is_empty() || around.union(area) == around),
                    "{area:?}"
                );
            }
        }
    }
}

#[test]
fn whole_bytes_of_layouts() {
    assert_eq!(Grain::of::<Rows<Index1>>(), Grain::new(8, 1));
    assert_eq!(Grain::of::<Rows<Lsb0<Index2>>>(), Grain::new(4, 1));
    assert_eq!(Grain::of::<Rows<Rgb565>>(), Grain::new(1, 1));
    assert_eq!(Grain::of::<Rows<embedded_graphics::pixelcolor::Rgb888>>(), Grain::new(1, 1));
    assert_eq!(Grain::of::<Planes<Index2>>(), Grain::new(8, 1));
    assert_eq!(Grain::of::<Pages<Index1>>(), Grain::new(1, 8));
    assert_eq!(Grain::of::<Packed12>(), Grain::new(2, 1));
}

/// Some shapes that move.
#[derive(Clone, Copy)]
struct Scene([(i32, i32); 3]);

impl Scene {
    fn draw<S: Surface>(self, on: &mut S, color: impl Fn(u32) -> S::Color) {
        let [a, b, c] = self.0;
        on.fill_rectangle(Rect::new(a.0, a.1, a.0 + 7, a.1 + 5), color(1));
        on.fill_ellipse(Rect::new(b.0, b.1, b.0 + 9, b.1 + 9), color(2));
        on.draw_line(b, c, color(3));
    }

    fn moved(mut self, rng: &mut Rng) -> Self {
        for at in &mut self.0 {
            if rng.one_in(2) {
                *at = (rng.int(-4, 44), rng.int(-4, 32));
            }
        }
        self
    }

    /// All of it, or what lies in some rectangles.
    fn redraw<L: Layout>(self, memory: &mut [u8], areas: &[Rect], color: impl Fn(u32) -> L::Color) {
        for &area in areas {
            let mut frame = open::<L>(memory);
            let mut frame = frame.clipped(area);
            frame.clear(color(0));
            self.draw(&mut frame, &color);
        }
    }

    /// Where two scenes differ.
    fn changes<const N: usize>(self, after: Self) -> Damage<N> {
        let mut damage = Damage::new();
        let mut counter = Counter::<BinaryColor>::new(SCREEN);
        let mut recorder = Recorder::new(&mut counter, |area| damage.add(area));
        self.draw(&mut recorder, |_| BinaryColor::On);
        after.draw(&mut recorder, |_| BinaryColor::On);
        damage
    }
}

/// A display with a memory of its own, which is sent what is new since the frame it has.
struct Panel {
    memory: Vec<u8>,
    sent: Option<u32>,
}

impl Panel {
    fn new<L: Layout>() -> Self {
        Self { memory: vec![0x5A; bytes::<L>()], sent: None }
    }

    fn receive<L: Layout, const N: usize, const FRAMES: usize>(
        &mut self,
        from: &Buffer<(Vec<u8>, History<N, FRAMES>)>,
        grain: Grain,
    ) {
        let (memory, history) = &**from;
        let picture = Frame::<_, L>::new(&memory[..], WIDTH, HEIGHT).expect("the right size");
        for job in grain.jobs(&history.since(self.sent, SCREEN), SCREEN) {
            open::<L>(&mut self.memory).blit(job.top_left(), &picture.view(job));
        }
        self.sent = Some(from.frame());
        assert!(
            open::<L>(&mut self.memory).colors(SCREEN).eq(picture.colors(SCREEN)),
            "what was sent is what is shown"
        );
    }
}

/// Frames of a scene that moves, where only what is missing is drawn, in a chain of buffers that is flipped now and then.
fn chain<F: PixelFormat, L: Layout<Color = F::Color>, const M: usize, const N: usize, const FRAMES: usize>(seed: u64) {
    let mut rng = Rng::new(seed);
    let color = |n: u32| F::unpack(n & (u32::MAX >> (32 - F::BITS)));
    let mut ages = [0; 8];
    let buffers = [(); M].map(|()| (vec![0xA5; bytes::<L>()], History::<N, FRAMES>::new()));
    let (mut chain, mut history) = (Swapchain::new(buffers), History::new());
    let mut panel = Panel::new::<L>();
    let mut scene = Scene([(0, 0), (9, 9), (30, 20)]);
    // What the last frame in the history shows.
    let mut recorded = scene;
    for _ in 0..cases(400) {
        if rng.one_in(2) {
            if let Some(shown) = chain.flip() {
                panel.receive::<L, N, FRAMES>(shown, Grain::of::<L>());
            }
        }
        let Some(mut buffer) = chain.begin() else { continue };
        if rng.one_in(9) {
            // Something else was drawn on it. Its number is left out, or it counts as a frame in which nothing changed.
            buffer.0.fill(0x33);
            if rng.one_in(2) {
                history.record(buffer.frame(), &Damage::new());
            }
            chain.cancel(buffer);
            continue;
        }
        scene = scene.moved(&mut rng);
        history.record(buffer.frame(), &recorded.changes(scene));
        recorded = scene;
        let missing = history.missing(&buffer, SCREEN);
        ages[buffer.age().map_or(0, |age| age.get().min(7) as usize)] += 1;
        assert!(
            missing.areas() == [SCREEN] || buffer.age().map_or(0, NonZeroU32::get) <= FRAMES as u32,
            "it is too old"
        );
        scene.redraw::<L>(&mut buffer.0, missing.areas(), color);
        let mut whole = vec![0; bytes::<L>()];
        scene.redraw::<L>(&mut whole, &[SCREEN], color);
        let lost = changed::<L>(&mut whole, &mut buffer.0, SCREEN);
        assert!(lost.is_empty(), "age {:?}, {missing:?}: {lost:?}", buffer.age());
        buffer.1 = history.clone();
        chain.finish(buffer);
    }
    assert!(ages[M] > 20 || M == 3 && ages[2] > 20, "ages of {M} buffers: {ages:?}");
}

#[test]
fn what_is_missing_is_all_that_has_to_be_drawn() {
    macro_rules! chains {
        ($($buffers:literal)*) => {$(
            chain::<Index4, Rows<Index4>, $buffers, 1, 1>(1530);
            chain::<Index4, Rows<Index4>, $buffers, 1, 3>(1531);
            chain::<Index4, Rows<Index4>, $buffers, 2, 2>(1532);
            chain::<Index4, Rows<Index4>, $buffers, 8, 4>(1533);
            chain::<BinaryColor, Pages<Lsb0<BinaryColor>>, $buffers, 3, 3>(1534);
            chain::<Rgb444, Packed12, $buffers, 4, 3>(1535);
        )*};
    }
    chains!(1 2 3);
}

/// The same through queues, where the history of a frame travels with it.
fn queues<const M: usize, const PLACES: usize, const N: usize, const FRAMES: usize>(seed: u64) {
    type L = Rows<Index4>;
    let mut rng = Rng::new(seed);
    let color = |n: u32| Index4::new(n as u8);
    let mut queues = Queues::<(Vec<u8>, History<N, FRAMES>), PLACES>::new();
    let buffers = [(); M].map(|()| (vec![0xA5; bytes::<L>()], History::new()));
    let (mut drawer, mut display) = queues.split(buffers).expect("a place more");
    let (mut panel, mut history) = (Panel::new::<L>(), History::new());
    let mut scene = Scene([(0, 0), (9, 9), (30, 20)]);
    let mut frames = 0;
    for _ in 0..cases(600) {
        if rng.one_in(2) {
            if let Some(shown) = display.flip() {
                panel.receive::<L, N, FRAMES>(shown, Grain::new(2, 3));
            }
        }
        let Some(mut buffer) = drawer.begin() else { continue };
        frames += 1;
        let before = scene;
        scene = scene.moved(&mut rng);
        history.record(buffer.frame(), &before.changes(scene));
        let missing = history.missing(&buffer, SCREEN);
        scene.redraw::<L>(&mut buffer.0, missing.areas(), color);
        let mut whole = vec![0; bytes::<L>()];
        scene.redraw::<L>(&mut whole, &[SCREEN], color);
        let lost = changed::<L>(&mut whole, &mut buffer.0, SCREEN);
        assert!(lost.is_empty(), "age {:?}, {missing:?}: {lost:?}", buffer.age());
        buffer.1 = history.clone();
        drawer.finish(buffer);
    }
    assert!(frames > cases(600) / 3, "{frames} frames");
}

#[test]
fn a_history_travels_through_queues() {
    queues::<2, 3, 2, 2>(1540);
    queues::<3, 4, 1, 3>(1541);
    queues::<3, 4, 8, 4>(1542);
}

/// A picture that is drawn over, call after call: what was recorded is brought to the other buffers.
fn painted<const M: usize, const N: usize, const FRAMES: usize>(seed: u64) {
    type L = Rows<Index4>;
    let (mut rng, mut scratch) = (Rng::new(seed), Scratch::new(seed));
    let mut chain = Swapchain::new([(); M].map(|()| vec![0xA5; bytes::<L>()]));
    let mut history = History::<N, FRAMES>::new();
    // The newest picture.
    let mut picture = vec![0; bytes::<L>()];
    for _ in 0..cases(400) {
        if rng.one_in(2) {
            chain.flip();
        }
        let Some(mut buffer) = chain.begin() else { continue };
        for &area in history.missing(&buffer, SCREEN).areas() {
            let newest = Frame::<_, L>::new(&picture[..], WIDTH, HEIGHT).expect("the right size");
            open::<L>(&mut buffer).blit(area.top_left(), &newest.view(area));
        }
        let lost = changed::<L>(&mut picture, &mut buffer, SCREEN);
        assert!(lost.is_empty(), "age {:?}: {lost:?}", buffer.age());
        let mut damage = Damage::new();
        let bits: Vec<u8> = (0..1_200).map(|_| rng.bits() as u8).collect();
        for _ in 0..rng.below(4) {
            let colors = [(); 2].map(|()| color::<Index4>(&mut rng));
            let mut a = scratch.arguments::<L>(&mut Input(&bits), Ground::Near(SCREEN), colors);
            recorded_call(&mut open::<L>(&mut buffer), &mut |area| damage.add(area), &mut a, rng.index(calls::COUNT));
        }
        picture.copy_from_slice(&buffer);
        history.record(buffer.frame(), &damage);
        chain.finish(buffer);
    }
}

#[test]
fn what_was_recorded_is_all_that_has_to_be_copied() {
    painted::<1, 1, 1>(1550);
    painted::<2, 1, 2>(1551);
    painted::<2, 4, 2>(1552);
    painted::<3, 2, 3>(1553);
    painted::<3, 8, 4>(1554);
}
