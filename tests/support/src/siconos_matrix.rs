//! Reading of matrices from the files of Siconos.
//!
//! | first number | form |
//! |---|---|
//! | `0` | dense, column by column |
//! | `1` | in blocks, row by row; each block column by column |
//! | `2` | sparse, as CSparse prints it, in columns or in triplets of row, column and entry |

use crate::siconos::Error;
use nalgebra::DMatrix;
use std::str::{FromStr, SplitWhitespace};

const ENTRY: &str = "an entry of a matrix";

/// Reads the next matrix. Given numbers of rows or columns must match the numbers in the file.
pub(crate) fn matrix(
    words: &mut Tokens<'_>,
    rows: Option<usize>,
    columns: Option<usize>,
) -> Result<DMatrix<f64>, Error> {
    let allowed = "the form of a matrix: 0 (dense), 1 (in blocks) or 2 (sparse)";
    let form: usize = words.number(allowed)?;
    if form > 2 {
        return Err(words.wrong(form.to_string(), allowed));
    }
    let count = |words: &mut Tokens<'_>, must: Option<usize>| match must {
        Some(must) => {
            words.exactly(must, "the number of rows or columns that the problem has").map(|()| must)
        }
        None => words.number("the number of rows or columns of a matrix"),
    };
    let rows = count(words, rows)?;
    let columns = count(words, columns)?;
    // The matrix is stored densely; this size takes a gigabyte.
    if rows.saturating_mul(columns) > 1 << 27 {
        return Err(
            words.wrong(format!("{rows} {columns}"), "rows and columns of a matrix that fits into memory")
        );
    }
    match form {
        0 => dense(words, rows, columns),
        1 => in_blocks(words, rows, columns),
        _ => sparse(words, rows, columns),
    }
}

fn dense(words: &mut Tokens<'_>, rows: usize, columns: usize) -> Result<DMatrix<f64>, Error> {
    for count in [rows, columns] {
        words.exactly(count, "the number of rows or columns once more")?;
    }
    Ok(DMatrix::from_vec(rows, columns, words.entries(rows * columns, ENTRY)?))
}

fn in_blocks(words: &mut Tokens<'_>, rows: usize, columns: usize) -> Result<DMatrix<f64>, Error> {
    let count: usize = words.number("the number of blocks")?;
    let down: usize = words.number("the number of rows of blocks")?;
    let across: usize = words.number("the number of columns of blocks")?;
    if down > rows || across > columns {
        return Err(
            words.wrong(format!("{down} {across}"), "no more rows and columns of blocks than of the matrix")
        );
    }
    let mut ends = |count: usize, size: usize| -> Result<Vec<usize>, Error> {
        let mut ends: Vec<usize> = vec![0];
        for _ in 0..count {
            let before: usize = ends[ends.len() - 1];
            let end: usize = words.number("the end of a row or column of blocks")?;
            if end < before || end > size {
                return Err(words.wrong(
                    end.to_string(),
                    "the end of a row or column of blocks, in order and within the matrix",
                ));
            }
            ends.push(end);
        }
        Ok(ends)
    };
    let (row_ends, column_ends) = (ends(down, rows)?, ends(across, columns)?);
    let starts: usize = words.number("the number of rows of blocks and one more")?;
    let listed: usize = words.number("the number of blocks once more")?;
    if starts > down + 1 || listed > count {
        return Err(words.wrong(listed.to_string(), "no more rows and blocks than were announced"));
    }
    let first = words.entries::<usize>(starts, "where a row begins in the list of blocks")?;
    let column = words.entries::<usize>(listed, "the column of a block")?;
    let mut w = DMatrix::zeros(rows, columns);
    for row in 0..starts.saturating_sub(1) {
        for block in first[row]..first[row + 1] {
            words.exactly(block, "the number of the block")?;
            let Some(column) = column.get(block).filter(|column| **column < across) else {
                return Err(words.wrong(block.to_string(), "a block whose column was listed"));
            };
            for j in column_ends[*column]..column_ends[*column + 1] {
                for i in row_ends[row]..row_ends[row + 1] {
                    w[(i, j)] = words.number(ENTRY)?;
                }
            }
        }
    }
    Ok(w)
}

fn sparse(words: &mut Tokens<'_>, rows: usize, columns: usize) -> Result<DMatrix<f64>, Error> {
    // Skips the header, which has the origin, the version of CSparse and the size.
    while words.word("nnz:, the number of entries of the matrix")? != "nnz:" {}
    let word = words.word("the number of entries of the matrix")?;
    let count: usize = words.parse(word.trim_end_matches(','), "the number of entries of the matrix")?;
    if word.ends_with(',') {
        words.word("1-norm:")?;
        words.word("the norm of the matrix")?;
    }
    let mut w = DMatrix::zeros(rows, columns);
    let (mut column, mut left) = (0, count);
    while left > 0 {
        let word = words.word("a row or a column of the matrix")?;
        if word == "col" {
            column = words.number("a column of the matrix")?;
            for _ in 0..5 {
                words.word("where the column lies")?;
            }
            continue;
        }
        let row: usize = words.parse(word, "a row of the matrix")?;
        let next = words.word("a colon or a column of the matrix")?;
        if next != ":" {
            column = words.parse(next, "a column of the matrix")?;
            words.word("a colon")?;
        }
        if row >= rows || column >= columns {
            return Err(words.wrong(format!("{row} {column}"), "a row and a column of the matrix"));
        }
        w[(row, column)] += words.number::<f64>(ENTRY)?;
        left -= 1;
    }
    Ok(w)
}

/// The words of a text, and the number of words read.
pub(crate) struct Tokens<'a> {
    rest: SplitWhitespace<'a>,
    read: usize,
}

impl<'a> Tokens<'a> {
    pub(crate) fn of(text: &'a str) -> Self {
        Self { rest: text.split_whitespace(), read: 0 }
    }

    fn word(&mut self, allowed: &'static str) -> Result<&'a str, Error> {
        self.read += 1;
        self.rest.next().ok_or(Error::Word { at: self.read, word: None, allowed })
    }

    fn parse<T: FromStr>(&self, word: &str, allowed: &'static str) -> Result<T, Error> {
        word.parse().map_err(|_| self.wrong(word.to_owned(), allowed))
    }

    pub(crate) fn number<T: FromStr>(&mut self, allowed: &'static str) -> Result<T, Error> {
        let word = self.word(allowed)?;
        self.parse(word, allowed)
    }

    pub(crate) fn entries<T: FromStr>(
        &mut self,
        count: usize,
        allowed: &'static str,
    ) -> Result<Vec<T>, Error> {
        (0..count).map(|_| self.number(allowed)).collect()
    }

    fn exactly(&mut self, value: usize, allowed: &'static str) -> Result<(), Error> {
        let given: usize = self.number(allowed)?;
        if given == value { Ok(()) } else { Err(self.wrong(given.to_string(), allowed)) }
    }

    /// The error for the last word read, which is not of the required kind.
    pub(crate) fn wrong(&self, word: String, allowed: &'static str) -> Error {
        Error::Word { at: self.read, word: Some(word), allowed }
    }
}
