//! Work on all processors, of which the results come out in the order in which the work came in.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

/// How much work waits, for each worker: enough that none is idle, and little to hold.
const WAITING: usize = 2;

/// Hands work on; `false` once nobody wants the results.
pub type HandOn<'h, Work> = dyn Fn(Work) -> bool + 'h;

/// Three things at once: `bring` hands work on, a worker for each processor does it, `take` takes the results in order.
///
/// A worker is made by `worker` in its own thread, so that it may remember something from one piece of work to the next.
///
/// # Errors
///
/// That of `take`, else that of `bring`; whichever fails, the other soon ends.
pub fn in_order<Work: Send, Made: Send, Worker: FnMut(Work) -> Made, Fault: Send>(
    bring: impl FnOnce(&HandOn<Work>) -> Result<(), Fault> + Send,
    worker: impl Fn() -> Worker + Sync,
    mut take: impl FnMut(Made) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    let (to_do, work) = sync_channel::<(Work, SyncSender<Made>)>(workers * WAITING);
    let (promise, promised) = sync_channel::<Receiver<Made>>(workers * WAITING * 2);
    let work = Mutex::new(work);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                let mut worker = worker();
                // The lock is held while waiting: whoever has it takes the next, the others wait for the lock instead.
                let next = || work.lock().ok()?.recv().ok();
                while let Some((work, made)) = next() {
                    // Nobody waits for it once taking has failed.
                    let _ = made.send(worker(work));
                }
            });
        }
        let brought = scope.spawn(move || {
            bring(&|work| {
                let (made, result) = sync_channel(1);
                promise.send(result).is_ok() && to_do.send((work, made)).is_ok()
            })
        });
        // A promise that is not kept is that of a worker who panicked; the scope passes the panic on.
        let taken = promised.iter().map_while(|result| result.recv().ok()).try_for_each(&mut take);
        drop(promised);
        let brought = brought.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        taken.and(brought)
    })
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    #[test]
    fn results_come_in_order_though_early_work_takes_longer() {
        let mut taken = Vec::new();
        let bring = |hand_on: &HandOn<usize>| {
            assert!((0..500).all(hand_on));
            Ok::<(), ()>(())
        };
        let worker =
            || |work: usize| (0..(500 - work) * 50).fold(work, |sum, next| std::hint::black_box(sum ^ next ^ next));
        in_order(bring, worker, |made| {
            taken.push(made);
            Ok(())
        })
        .unwrap();
        assert_eq!(taken, (0..500).collect::<Vec<_>>());
    }

    #[test]
    fn nothing_more_is_brought_once_nobody_takes_it() {
        let brought = AtomicUsize::new(0);
        let bring = |hand_on: &HandOn<usize>| {
            while hand_on(brought.fetch_add(1, Ordering::Relaxed)) {}
            Ok(())
        };
        let take = |made: usize| if made < 20 { Ok(()) } else { Err("full") };
        assert_eq!(in_order(bring, || |work| work, take), Err("full"));
        let workers = thread::available_parallelism().map_or(1, NonZero::get);
        assert!(brought.into_inner() < 30 + workers * WAITING * 4);
        // And a fault in bringing comes after what was brought.
        let mut taken = 0;
        let bring = |hand_on: &HandOn<()>| {
            hand_on(());
            Err("torn")
        };
        let take = |()| {
            taken += 1;
            Ok(())
        };
        assert_eq!((in_order(bring, || |()| (), take), taken), (Err("torn"), 1));
    }
}
