//! The list of what has changed: rectangles, frames before this one, and what is sent of it.

use core::mem;

use embedded_raster::{
    present::{Grain, History, Jobs, Swapchain},
    surface::{Damage, Recorder},
    Frame, Layout,
};

use crate::{answer::sum, calls, Arguments};

calls! {
    /// Makes the call of a number below that of [`NAMES`] on a list, which is whatever the calls before left.
    NAMES, call[L: Layout](on: &mut Damage<2>, a)
    {
        let (window, [columns, rows], other) = (a.window, a.halves(0), a.changed());
    }
    [Damage]
    new => Damage::<2>::new().bounds();
    add => on.add(a.areas[0]);
    add_all => on.add_all(&other);
    clear => on.clear();
    is_empty => on.is_empty();
    areas => sum(on.areas().iter().copied());
    bounds => on.bounds();
    default => Damage::<1>::default().bounds();
    clone => on.clone().bounds();
    [Recorder]
    new => {
        let (memory, number) = (mem::take(&mut a.out), a.length(5) % crate::COUNT);
        let answer = Frame::<_, L>::new(&mut *memory, 7, 9).map(|mut frame| {
            let mut recorder = Recorder::new(&mut frame, |area| on.add(area));
            crate::call(&mut recorder, a, number)
        });
        a.out = memory;
        answer.map_or(0, |answer| answer.wrapping_add(sum(on.areas().iter().copied())))
    };
    [History]
    new => History::<2, 3>::new().since(None, window).bounds();
    record => a.history().since(a.frame(1), window).bounds();
    since => a.history().since(a.frame(2), window).bounds();
    missing => {
        let mut chain = Swapchain::new([0_u8; 2]);
        let mut answer = 0;
        for frame in 0..3 {
            let Some(buffer) = chain.begin() else { break };
            let mut history = a.history();
            history.record(buffer.frame().wrapping_sub(frame), on);
            answer = history.missing(&buffer, window).areas().len().wrapping_add(answer);
            chain.finish(buffer);
            chain.flip();
        }
        answer
    };
    default => History::<1, 1>::default().since(a.frame(0), window).bounds();
    [Grain]
    new => Grain::new(columns, rows).around(a.areas[0], window);
    of => Grain::of::<L>().around(a.areas[0], window);
    around => Grain::new(rows, columns).around(a.areas[1], window);
    jobs => sum(Grain::new(columns, rows).jobs(on, window));
    [Jobs]
    next => Grain::of::<L>().jobs(&other, window).next().unwrap_or_default();
    size_hint => Jobs::size_hint(&Grain::of::<L>().jobs(on, window)).0;
}

impl<L: Layout> Arguments<'_, L> {
    fn changed(&self) -> Damage<3> {
        let mut damage = Damage::new();
        self.areas.iter().chain([&self.window]).for_each(|&area| damage.add(area));
        damage
    }

    /// The number of a frame, if it has one.
    fn frame(&self, at: usize) -> Option<u32> {
        self.numbers.get(at).map(|number| number.cast_unsigned()).filter(|number| number % 5 != 0)
    }

    /// Three frames, sometimes one after the other.
    fn history(&self) -> History<2, 2> {
        let (mut history, mut damage) = (History::new(), Damage::new());
        let first = self.frame(1).unwrap_or(u32::MAX);
        let frames = [first, first.wrapping_add(1), self.frame(3).unwrap_or(first)];
        for (frame, &area) in frames.into_iter().zip(self.areas.iter().cycle()) {
            damage.add(area);
            history.record(frame, &damage);
        }
        history
    }
}
