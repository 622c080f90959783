//! Who may enter: one-time keys, the cookie, the token of a file.

use std::collections::VecDeque;
use std::fmt::Write as _;
use std::io;
use std::sync::{Mutex, PoisonError};

/// Number of random bytes of a secret.
const SECRET_BYTES: usize = 32;
/// Largest number of keys that can be used; older ones are void.
const MAX_KEYS: usize = 16;

/// Secrets of a server.
pub struct Access {
    cookie_name: String,
    cookie: String,
    token: Option<String>,
    keys: Mutex<VecDeque<String>>,
}

impl Access {
    /// New secrets for a server on a port; cookies of a host are shared by all its ports, so the name contains the port.
    ///
    /// # Errors
    /// If the operating system has no random numbers.
    pub fn new(port: u16, token: Option<String>) -> io::Result<Self> {
        Ok(Self { cookie_name: format!("jmanager-{port}"), cookie: secret()?, token, keys: Mutex::default() })
    }

    /// Returns a new key; each works once.
    ///
    /// # Errors
    /// If the operating system has no random numbers.
    pub fn new_key(&self) -> io::Result<String> {
        let key = secret()?;
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        if keys.len() == MAX_KEYS {
            keys.pop_front();
        }
        keys.push_back(key.clone());
        Ok(key)
    }

    /// Uses a key up; returns whether it was valid.
    #[must_use]
    pub fn redeem(&self, key: &str) -> bool {
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(index) = keys.iter().position(|known| equal(known, key)) else { return false };
        keys.remove(index);
        true
    }

    /// Whether this is the token of the server's file.
    #[must_use]
    pub fn is_token(&self, token: &str) -> bool {
        self.token.as_ref().is_some_and(|known| equal(known, token))
    }

    /// Whether the server has a token, so that a page can be entered with it.
    #[must_use]
    pub const fn has_token(&self) -> bool {
        self.token.is_some()
    }

    /// Whether a `Cookie` header contains the server's cookie.
    #[must_use]
    pub fn has_cookie(&self, header: &str) -> bool {
        header
            .split(';')
            .filter_map(|pair| pair.trim().split_once('='))
            .any(|(name, value)| name == self.cookie_name && equal(value, &self.cookie))
    }

    /// The `Set-Cookie` header that lets a browser in.
    #[must_use]
    pub fn set_cookie(&self) -> String {
        format!("{}={}; Path=/; HttpOnly; SameSite=Strict", self.cookie_name, self.cookie)
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

/// Compares secrets in a time that does not depend on where they differ.
fn equal(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).fold(0, |differs, (a, b)| differs | (a ^ b)) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_works_once() {
        let access = Access::new(1, None).unwrap();
        let (one, two) = (access.new_key().unwrap(), access.new_key().unwrap());
        assert_eq!(one.len(), 64);
        assert_ne!(one, two);
        assert!(!access.redeem(""));
        assert!(!access.redeem(&one[1..]));
        assert!(access.redeem(&one));
        assert!(!access.redeem(&one));
        assert!(access.redeem(&two));
    }

    #[test]
    fn old_keys_are_void() {
        let access = Access::new(1, None).unwrap();
        let first = access.new_key().unwrap();
        let later: Vec<_> = (0..MAX_KEYS).map(|_| access.new_key().unwrap()).collect();
        assert!(!access.redeem(&first));
        assert!(later.iter().all(|key| access.redeem(key)));
    }

    #[test]
    fn only_the_own_cookie_counts() {
        let access = Access::new(7, Some("t".to_owned())).unwrap();
        let set = access.set_cookie();
        let pair = set.split(';').next().unwrap();
        assert!(access.has_cookie(pair));
        assert!(access.has_cookie(&format!("a=b; {pair}; c=d")));
        for wrong in ["", "jmanager-7=", "jmanager-7=0", &pair.replace("-7=", "-8="), &pair[..pair.len() - 1]] {
            assert!(!access.has_cookie(wrong), "{wrong}");
        }
        assert!(access.is_token("t") && !access.is_token("") && !access.is_token("u"));
        assert!(!Access::new(7, None).unwrap().is_token(""));
    }
}
