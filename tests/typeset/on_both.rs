//! Work that is shared out: an engine or a browser keeps no more than one processor busy.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::{iter, panic, thread};

/// What workers on both processors make of each item, in the order of the items.
pub fn on_both<Item: Sync, Made: Send>(items: &[Item], work: impl Fn(&Item) -> Made + Sync) -> Vec<Made> {
    let next = AtomicUsize::new(0);
    let mut made: Vec<(usize, Made)> = thread::scope(|scope| {
        let worker = || {
            let places = iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)));
            places.map_while(|place| Some((place, work(items.get(place)?)))).collect::<Vec<_>>()
        };
        let workers = [scope.spawn(worker), scope.spawn(worker)];
        let joined = workers.map(|worker| worker.join().unwrap_or_else(|cause| panic::resume_unwind(cause)));
        joined.into_iter().flatten().collect()
    });
    made.sort_by_key(|(place, _)| *place);
    made.into_iter().map(|(_, made)| made).collect()
}
