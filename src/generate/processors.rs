//! Work in many pieces that do not wait for each other, on all processors.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Does all pieces of some work on all processors; what each processor has done.
pub(crate) fn on_all_processors<P: Sync, D: Send>(
    pieces: &[P],
    empty: &(dyn Fn() -> D + Sync),
    work: &(dyn Fn(&mut D, &P) + Sync),
) -> Vec<D> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = empty();
        while let Some(piece) = pieces.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(&mut done, piece);
        }
        done
    };
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        // A panic in a worker is a bug in carom and is passed on as it is.
        let join = |worker: thread::ScopedJoinHandle<D>| {
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        workers.into_iter().map(join).collect()
    })
}
