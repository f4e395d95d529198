//! Answers lines of input in order, on all cores, in bounded memory.
//!
//! One thread reads lines and sends them in blocks to workers; the caller's thread writes the answers in order. A queue of bounded length holds, for
//! each block, the receiving end of a channel for the answer to this block. The reader waits while the queue is full. A block ends when it is full,
//! or when no further line has arrived yet. Output is flushed before the program waits for input, so that a user at a keyboard gets an answer to each
//! line.

use std::io::{self, BufReader, Read, Write};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, SyncSender, TryRecvError, channel, sync_channel};
use std::thread;

use super::line::{InputLine, LONGEST_LINE};
use super::options::StreamOptions;
use super::reply::Reply;

/// A block (a batch of input lines that one worker answers) is full once it has this number of lines. With a smaller number more time goes into
/// passing blocks between threads; with a larger one more lines are held in memory.
const LINES_OF_A_BLOCK: usize = 64;
/// Size, bytes, at which a block of input lines is full, and size of the input buffer.
pub const BLOCK_BYTES: usize = 1 << 16;

/// Numbers of lines that were read and answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Lines read, empty ones included.
    pub lines: usize,
    /// Lines whose questions were answered; blank lines count neither here nor as errors.
    pub answered: usize,
    /// Lines with an error in place of answers.
    pub errors: usize,
}

/// Upper bound on the number of lines that are read but whose answers are not yet written. Lines that are still in the input buffer ([`BLOCK_BYTES`]
/// bytes) do not count.
#[must_use]
pub const fn most_ahead(threads: usize) -> usize {
    // The blocks in the queue, one block for which the reader waits until the queue has room, and one block that is being written.
    (queue(threads) + 2) * LINES_OF_A_BLOCK
}

/// Length of the queue, in blocks of lines. It holds blocks whose answers are being computed, and answered blocks that wait until earlier blocks are
/// written.
const fn queue(threads: usize) -> usize {
    4 * threads
}

struct Job {
    lines: Vec<InputLine>,
    answer: Sender<io::Result<Answered>>,
}

struct Answered {
    text: Vec<u8>,
    tally: Tally,
}

/// Answers every line of `input` by one line of `output`, in order. The [module](super) describes input and output; [`StreamOptions`] has the number
/// of threads and limits for every scene. Returns the numbers of lines read and answered.
///
/// # Errors
/// The error of reading or writing. A line that is no scene has an error in place of its answer.
pub fn answer_lines(
    input: impl Read + Send,
    mut output: impl Write,
    options: &StreamOptions,
) -> io::Result<Tally> {
    let threads = options.threads.max(1);
    // A job is a block of lines, with the sending end of the channel for its answer. The channel of jobs needs no bound, since every job has an entry
    // in the bounded queue.
    let (put_job, take_job) = channel::<Job>();
    let (put_place, take_place) = sync_channel::<Receiver<io::Result<Answered>>>(queue(threads));
    let take_job = &Mutex::new(take_job);
    thread::scope(|scope| {
        let reader = scope.spawn(move || read_blocks(input, &put_job, &put_place));
        for _ in 0..threads {
            scope.spawn(move || {
                while let Some(Job { lines, answer }) = next(take_job) {
                    // Sending fails if the receiver is gone, because writing the output failed.
                    let _ = answer.send(answer_block(&lines, options));
                }
            });
        }
        let written = write_blocks(&take_place, &mut output);
        // Dropping the receiver closes the queue, and the reader stops.
        drop(take_place);
        let read = reader.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        written.and_then(|tally| read.map(|lines| Tally { lines, ..tally }))
    })
}

fn next(jobs: &Mutex<Receiver<Job>>) -> Option<Job> {
    jobs.lock().ok()?.recv().ok()
}

/// Reads lines into blocks, sends each block to the workers, and returns the number of lines.
fn read_blocks(
    input: impl Read,
    jobs: &Sender<Job>,
    places: &SyncSender<Receiver<io::Result<Answered>>>,
) -> io::Result<usize> {
    let mut input = BufReader::with_capacity(BLOCK_BYTES, input);
    let mut number = 0;
    let mut lines = Vec::new();
    let mut bytes = 0;
    loop {
        let line = read_line(&mut input, number + 1);
        let (more, failed) = match line {
            Ok(Some(line)) => {
                number += 1;
                bytes += line.text.len();
                lines.push(line);
                (true, None)
            }
            Ok(None) => (false, None),
            Err(error) => (false, Some(error)),
        };
        let full = lines.len() == LINES_OF_A_BLOCK || bytes >= BLOCK_BYTES;
        let waits = !input.buffer().contains(&b'\n');
        if !lines.is_empty() && (full || waits || !more) {
            let (answer, place) = channel();
            let job = Job { lines: std::mem::take(&mut lines), answer };
            bytes = 0;
            if places.send(place).is_err() || jobs.send(job).is_err() {
                return Ok(number);
            }
        }
        match failed {
            Some(error) => return Err(error),
            None if !more => return Ok(number),
            None => {}
        }
    }
}

/// The next line of input without its newline. A line that is longer than [`LONGEST_LINE`] (64 MiB) is cut to its first 1024 bytes. `None` at the end
/// of the input.
fn read_line(input: &mut BufReader<impl Read>, number: usize) -> io::Result<Option<InputLine>> {
    use io::BufRead;
    let mut line = InputLine { number, text: Vec::new(), too_long: false };
    let mut any = false;
    loop {
        let arrived = match input.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        if arrived.is_empty() {
            return Ok(any.then_some(line));
        }
        any = true;
        let end = arrived.iter().position(|byte| *byte == b'\n');
        let part = &arrived[..end.unwrap_or(arrived.len())];
        line.too_long |= line.text.len() + part.len() > LONGEST_LINE;
        if line.too_long {
            // The first 1024 bytes of a line that is too long are kept.
            line.text.truncate(1 << 10);
            line.text.shrink_to_fit();
        } else {
            line.text.extend_from_slice(part);
        }
        let used = part.len() + usize::from(end.is_some());
        input.consume(used);
        if end.is_some() {
            return Ok(Some(line));
        }
    }
}

fn write_blocks(
    places: &Receiver<Receiver<io::Result<Answered>>>,
    output: &mut impl Write,
) -> io::Result<Tally> {
    let mut tally = Tally::default();
    while let Some(place) = receive(places, output)? {
        // If a worker has panicked, its sender is dropped, and the thread scope reports the panic.
        let Some(block) = receive(&place, output)?.transpose()? else { break };
        output.write_all(&block.text)?;
        tally.answered += block.tally.answered;
        tally.errors += block.tally.errors;
    }
    output.flush()?;
    Ok(tally)
}

/// The next item of a channel, `None` if the channel is closed. The output is flushed before the call waits for the item.
fn receive<T>(from: &Receiver<T>, output: &mut impl Write) -> io::Result<Option<T>> {
    match from.try_recv() {
        Ok(item) => Ok(Some(item)),
        Err(TryRecvError::Disconnected) => Ok(None),
        Err(TryRecvError::Empty) => {
            output.flush()?;
            Ok(from.recv().ok())
        }
    }
}

fn answer_block(lines: &[InputLine], options: &StreamOptions) -> io::Result<Answered> {
    let mut block = Answered { text: Vec::new(), tally: Tally::default() };
    for line in lines {
        let reply = Reply::to(line, options);
        match reply.is_answered() {
            Some(true) => block.tally.answered += 1,
            Some(false) => block.tally.errors += 1,
            None => {}
        }
        serde_json::to_writer(&mut block.text, &reply)?;
        block.text.push(b'\n');
    }
    Ok(block)
}
