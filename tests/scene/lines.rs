//! The stream answers lines in order, the same for any number of threads. A bad line affects no other line, and memory is bounded.

use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use grasp_lcp::stream::{
    BLOCK_BYTES, LONGEST_LINE, StreamOptions, Tally, answer_line, answer_lines, most_ahead,
};
use serde_json::{Value, json};

/// A pinch that is held, slides or drops its load, with an id.
fn line(id: usize) -> String {
    let finger = |x: f64| {
        json!({
            "point": [x, 0.1], "normal": [-x, 0], "series_stiffness": [100, 80], "friction": 0.5, "command": [0.1, 0]
        })
    };
    let load = json!({ "force": [0.01, -0.03 * (id % 500) as f64] });
    let mut questions = vec![json!({ "solve": { "load": load } })];
    // Some lines have more questions than others, so that they take longer.
    for _ in 0..(id * 7 % 11) {
        questions.push(json!({ "onset": { "direction": load } }));
    }
    let contacts = [finger(1.0), finger(-1.0)];
    json!({ "format": "grasp-lcp/1", "id": id, "planar": { "contacts": contacts, "questions": questions } })
        .to_string()
}

/// Default options with this number of threads.
fn on(threads: usize) -> StreamOptions {
    StreamOptions::default().on_threads(threads)
}

fn run(input: &str, threads: usize) -> (Tally, String) {
    let mut output = Vec::new();
    let tally = answer_lines(input.as_bytes(), &mut output, &on(threads)).unwrap();
    (tally, String::from_utf8(output).unwrap())
}

fn replies(output: &str) -> Vec<Value> {
    output.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn answers_come_in_order_and_do_not_depend_on_threads() {
    let input: String = (1..=700).map(|id| line(id) + "\n").collect();
    let (tally, first) = run(&input, 1);
    assert_eq!(tally, Tally { lines: 700, answered: 700, errors: 0 });
    let outcomes: Vec<_> = replies(&first)
        .into_iter()
        .enumerate()
        .map(|(k, reply)| {
            assert_eq!((&reply["line"], &reply["id"]), (&json!(k + 1), &json!(k + 1)));
            reply["answers"][0]["solve"]["outcome"].as_str().unwrap().to_owned()
        })
        .collect();
    assert!(["equilibrium", "no_equilibrium"].iter().all(|o| outcomes.iter().any(|outcome| outcome == o)));
    for threads in [2, 3, 7] {
        assert!(run(&input, threads) == (tally, first.clone()), "{threads} threads");
    }
}

#[test]
fn a_bad_line_stays_by_itself() {
    let bad = [
        "no JSON".to_owned(),
        line(2).replace("0.5", "\"slippery\""),
        line(3).replace("grasp-lcp/1", "grasp-lcp/9"),
        line(4).replace("\"questions\":[", "\"questions\":[],\"unread\":["),
        line(5)[..100].to_owned(),
    ];
    // The last line has no line end.
    let input = format!("{}\n\n  \r\n{}\n{}\r\n{}", line(1), bad.join("\n"), line(6), line(7));
    for threads in [1, 2] {
        let (tally, output) = run(&input, threads);
        assert_eq!(tally, Tally { lines: 10, answered: 3, errors: 5 });
        let mut replies = replies(&output);
        let numbers: Vec<_> = replies.iter().map(|r| r["line"].as_u64().unwrap()).collect();
        assert_eq!(numbers, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
        for blank in replies.drain(1..3) {
            assert_eq!(blank.as_object().unwrap().keys().collect::<Vec<_>>(), ["blank", "line"]);
        }
        for (k, reply) in replies.iter().enumerate() {
            assert_ne!(reply.get("answers").is_some(), reply.get("error").is_some());
            assert_eq!(reply.get("error").is_some(), (1..=5).contains(&k), "{reply}");
        }
        let told: Vec<_> =
            replies.iter().map(|r| (&r["error"]["kind"], &r["error"]["field"], &r["id"])).collect();
        assert_eq!(told[1], (&json!("syntax"), &Value::Null, &Value::Null));
        assert_eq!(told[2], (&json!("scene"), &json!("planar.contacts[0].friction"), &json!(2)));
        assert_eq!(told[3], (&json!("scene"), &json!("format"), &json!(3)));
        assert_eq!(told[4], (&json!("scene"), &json!("planar.unread"), &json!(4)));
        assert_eq!(told[5].0, &json!("syntax"));
    }
    let silent = line(8).replace("\"solve\"", "\"onset\"").replace("load", "base");
    let nothing = json!({ "format": "grasp-lcp/1", "planar": { "contacts": [{
        "point": [0, 0], "normal": [0, 1], "series_stiffness": [1, 1]
    }] } });
    let (tally, output) = run(&format!("{silent}\n{nothing}\n"), 1);
    assert_eq!((tally.answered, tally.errors), (0, 2));
    let messages: Vec<_> =
        replies(&output).iter().map(|reply| reply["error"]["message"].to_string()).collect();
    assert!(messages[0].contains(&grasp_lcp::Error::NothingChanges.to_string()), "{messages:?}");
    assert!(messages[1].starts_with("\"no questions: "), "{messages:?}");
}

#[test]
fn bytes_that_are_no_text_are_a_bad_line() {
    let mut output = Vec::new();
    let input = [line(1).as_bytes(), b"\n\xff\xfe\x00\n", line(3).as_bytes(), b"\n"].concat();
    let tally = answer_lines(&input[..], &mut output, &on(2)).unwrap();
    assert_eq!(tally, Tally { lines: 3, answered: 2, errors: 1 });
    assert_eq!(replies(&String::from_utf8(output).unwrap())[1]["error"]["kind"], "syntax");
}

#[test]
fn a_line_without_end_is_not_kept() {
    let long = io::repeat(b' ').take(LONGEST_LINE as u64 + 1);
    let rest = format!("\n{}\n", line(2));
    let mut output = Vec::new();
    let tally = answer_lines(long.chain(rest.as_bytes()), &mut output, &on(1)).unwrap();
    assert_eq!(tally, Tally { lines: 2, answered: 1, errors: 1 });
    let reply = &replies(&String::from_utf8(output).unwrap())[0];
    let message = reply["error"]["message"].as_str().unwrap();
    assert!(message.contains(&format!(" {LONGEST_LINE} bytes")), "{message}");
}

/// An endless input that counts its lines.
struct Endless<'a> {
    text: Vec<u8>,
    at: usize,
    left: usize,
    given: &'a AtomicUsize,
    written: &'a AtomicUsize,
    most: &'a AtomicUsize,
}

impl Read for Endless<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < buffer.len() && self.left > 0 {
            buffer[count] = self.text[self.at];
            count += 1;
            self.at += 1;
            if self.at == self.text.len() {
                self.at = 0;
                self.left -= 1;
                self.given.fetch_add(1, Ordering::SeqCst);
            }
        }
        let ahead = self.given.load(Ordering::SeqCst) - self.written.load(Ordering::SeqCst);
        self.most.fetch_max(ahead, Ordering::SeqCst);
        Ok(count)
    }
}

fn lines_in(text: &[u8]) -> usize {
    text.split(|byte| *byte == b'\n').count() - 1
}

/// An output that counts lines, and is slow at first.
struct Slow<'a>(&'a AtomicUsize);

impl Write for Slow<'_> {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        if self.0.load(Ordering::SeqCst) < 200 {
            std::thread::sleep(Duration::from_millis(300));
        }
        self.0.fetch_add(lines_in(text), Ordering::SeqCst);
        Ok(text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn no_more_is_read_than_can_be_kept() {
    const LINES: usize = 20_000;
    for threads in [1, 2] {
        let [given, written, most] = [const { AtomicUsize::new(0) }; 3];
        let text = b"{\"format\": \"grasp-lcp/1\", \"id\": 1}\n".to_vec();
        // Lines of the last block that was read may be counted although the stream has not begun with them.
        let in_buffer = BLOCK_BYTES / text.len() + 1;
        let input = Endless { text, at: 0, left: LINES, given: &given, written: &written, most: &most };
        let tally = answer_lines(input, Slow(&written), &on(threads)).unwrap();
        assert_eq!(tally, Tally { lines: LINES, answered: 0, errors: LINES });
        assert_eq!(written.into_inner(), LINES);
        let most = most.into_inner();
        // The stream does read ahead, by at least half of the allowed number of lines, so that no core waits.
        assert!((most_ahead(threads) / 2..=most_ahead(threads) + in_buffer).contains(&most), "{most}");
    }
}

/// An input that gives the next line only after the answer to the last line.
struct Patient {
    lines: std::vec::IntoIter<String>,
    answered: Receiver<()>,
    asked: bool,
}

impl Read for Patient {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if std::mem::replace(&mut self.asked, true) {
            self.answered.recv_timeout(Duration::from_secs(20)).map_err(io::Error::other)?;
        }
        let Some(line) = self.lines.next() else { return Ok(0) };
        buffer[..line.len()].copy_from_slice(line.as_bytes());
        Ok(line.len())
    }
}

/// An output that reports each flush with a new answer.
struct Prompt {
    text: io::BufWriter<Vec<u8>>,
    shown: usize,
    answered: Sender<()>,
}

impl Write for Prompt {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        self.text.write(text)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.text.flush()?;
        let shown = lines_in(self.text.get_ref());
        if shown > std::mem::replace(&mut self.shown, shown) {
            let _ = self.answered.send(());
        }
        Ok(())
    }
}

#[test]
fn every_line_is_answered_before_the_next_one_comes() {
    let (tell, answered) = channel();
    let lines: Vec<String> = (1..=5).map(|id| line(id) + "\n").collect();
    let input = Patient { lines: lines.into_iter(), answered, asked: false };
    let output = Prompt { text: io::BufWriter::new(Vec::new()), shown: 0, answered: tell };
    assert_eq!(answer_lines(input, output, &on(2)).unwrap(), Tally { lines: 5, answered: 5, errors: 0 });
}

/// An output that fails after this number of writes.
struct Broken(usize);

impl Write for Broken {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        self.0 = self.0.checked_sub(1).ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn it_ends_when_nobody_reads_on() {
    let [given, written, most] = [const { AtomicUsize::new(0) }; 3];
    let text = (line(1) + "\n").into_bytes();
    let input = Endless { text, at: 0, left: 1_000_000, given: &given, written: &written, most: &most };
    let error = answer_lines(input, Broken(3), &on(2)).unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::BrokenPipe);
    assert!(given.into_inner() < 10_000);
}

/// An input that ends with an error.
struct Torn;

impl Read for Torn {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        Err(io::Error::other("disk is gone"))
    }
}

#[test]
fn what_was_read_before_reading_failed_is_answered() {
    let before = line(1) + "\n" + &line(2) + "\n";
    let mut output = Vec::new();
    let error = answer_lines(before.as_bytes().chain(Torn), &mut output, &on(2)).unwrap_err();
    assert_eq!(error.to_string(), "disk is gone");
    assert_eq!(replies(&String::from_utf8(output).unwrap()).len(), 2);
}

/// Every line of a stream is answered, even if the library panics in the scene of another line. This other line has an error as its answer.
#[test]
fn a_scene_that_panics_takes_no_other_line_with_it() {
    let input: String = (1..=300).map(|id| line(id) + "\n").collect();
    let (_, untouched) = run(&input, 1);
    let untouched = replies(&untouched);
    for threads in [1, 3] {
        let mut options = on(threads);
        options.fails_every = 7;
        let mut output = Vec::new();
        let tally = answer_lines(input.as_bytes(), &mut output, &options).unwrap();
        assert_eq!(tally, Tally { lines: 300, answered: 258, errors: 42 });
        let told = replies(std::str::from_utf8(&output).unwrap());
        assert_eq!(told.len(), 300);
        for (number, (reply, before)) in (1..).zip(told.iter().zip(&untouched)) {
            if number % 7 > 0 {
                assert_eq!(reply, before);
                continue;
            }
            assert_eq!((&reply["line"], &reply["id"]), (&json!(number), &json!(number)));
            assert_eq!(reply["error"]["kind"], "internal");
            assert!(reply["error"]["message"].as_str().unwrap().ends_with("(made to fail)"), "{reply}");
            assert!(reply.get("answers").is_none(), "{reply}");
        }
    }
}

/// A caller that asks line by line can continue after a panic.
#[test]
fn a_line_that_panics_is_answered_by_an_error() {
    let mut options = on(1);
    options.fails_every = 1;
    let told: Value = serde_json::from_str(&answer_line(line(3).as_bytes(), &options).unwrap()).unwrap();
    assert_eq!((&told["id"], &told["error"]["kind"]), (&json!(3), &json!("internal")));
}
