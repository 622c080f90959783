//! Access control: one-time keys, the secret of a page, the token of a file.

use std::collections::VecDeque;
use std::fmt::Write as _;
use std::io;
use std::sync::{Mutex, PoisonError};

use serde::Deserialize;

/// Number of random bytes of a secret.
const SECRET_BYTES: usize = 32;
/// Largest number of valid keys; older ones become invalid.
const MAX_KEYS: usize = 16;

/// The first message of a page. One valid proof is enough.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Enter {
    /// Key of a URL that the program printed.
    pub key: String,
    /// Random text of the page. A key works again for the page that used it, because a reload can lose the answer.
    pub page: String,
    /// Secret that the server sent to an earlier page of this origin.
    pub secret: String,
    /// Token in the server's token file.
    pub token: String,
}

/// Secrets of a server.
pub struct Access {
    secret: String,
    token: Option<String>,
    /// Valid keys, each with the page that used it.
    keys: Mutex<VecDeque<(String, Option<String>)>>,
}

impl Access {
    /// Creates the secrets of a server.
    ///
    /// # Errors
    /// If the operating system has no random numbers.
    pub fn new(token: Option<String>) -> io::Result<Self> {
        Ok(Self { secret: secret()?, token, keys: Mutex::default() })
    }

    /// Returns a new key; each works for one page.
    ///
    /// # Errors
    /// If the operating system has no random numbers.
    pub fn new_key(&self) -> io::Result<String> {
        let key = secret()?;
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        if keys.len() == MAX_KEYS {
            keys.pop_front();
        }
        keys.push_back((key.clone(), None));
        Ok(key)
    }

    /// Checks the proofs of a page and reserves its key for it. Returns the secret with which pages of the same origin enter again.
    ///
    /// # Errors
    /// The reason, if no proof is valid.
    pub fn enter(&self, enter: &Enter) -> Result<&str, &'static str> {
        let is_token = self.token.as_ref().is_some_and(|token| equal(token, &enter.token));
        if self.redeem(&enter.key, &enter.page) || equal(&self.secret, &enter.secret) || is_token {
            return Ok(&self.secret);
        }
        Err(match self.token {
            _ if enter.token.is_empty() => "this browser has not entered yet, or the address was used before",
            Some(_) => "this is not the token in the server's token file",
            None => "this server has no token: open the address that it printed",
        })
    }

    /// Reserves a key for a page; returns whether it is valid for this page. A page without a text of its own can use it once.
    fn redeem(&self, key: &str, page: &str) -> bool {
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        let Some((_, user)) = keys.iter_mut().find(|(known, _)| equal(known, key)) else { return false };
        let Some(user) = user else {
            *user = Some(page.to_owned());
            return true;
        };
        !page.is_empty() && equal(user, page)
    }
}

/// Returns a random text of hexadecimal digits.
///
/// # Errors
/// If the operating system has no random numbers.
pub(crate) fn secret() -> io::Result<String> {
    let mut bytes = [0_u8; SECRET_BYTES];
    getrandom::fill(&mut bytes).map_err(io::Error::other)?;
    Ok(bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    }))
}

/// Compares secrets in a time that does not depend on the position of a difference.
fn equal(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).fold(0, |differs, (a, b)| differs | (a ^ b)) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_keys_are_void_and_others_serve_one_page() {
        let access = Access::new(None).unwrap();
        let first = access.new_key().unwrap();
        let later: Vec<_> = (0..MAX_KEYS).map(|_| access.new_key().unwrap()).collect();
        assert_eq!(first.len(), 64);
        assert!(!access.redeem(&first, "") && !access.redeem("", "") && !access.redeem(&later[0][1..], ""));
        assert!(later.iter().all(|key| access.redeem(key, "one") && access.redeem(key, "one")));
        assert!(!later.iter().any(|key| access.redeem(key, "other") || access.redeem(key, "")));
        let last = access.new_key().unwrap();
        assert!(access.redeem(&last, "") && !access.redeem(&last, ""));
    }
}
