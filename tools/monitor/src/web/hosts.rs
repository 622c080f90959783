//! Names and addresses of the server.

use std::net::{IpAddr, SocketAddr};

/// Values of `Host` and `Origin` that denote this server.
#[derive(Clone, Debug)]
pub struct Hosts {
    /// Address with which a browser of this computer reaches the server.
    own: SocketAddr,
    names: Vec<String>,
    addresses: Vec<IpAddr>,
    /// Whether the server listens on all addresses of the computer, so that any address literal can be its own.
    any_address: bool,
}

impl Hosts {
    /// Hosts of a server that listens on an address.
    #[must_use]
    pub fn new(address: SocketAddr, names: Vec<String>) -> Self {
        let mut all = vec!["localhost".to_owned()];
        all.extend(names);
        let addresses = vec![address.ip(), IpAddr::from([127, 0, 0, 1]), IpAddr::from([0, 0, 0, 0, 0, 0, 0, 1])];
        let any_address = address.ip().is_unspecified();
        let own = if any_address { SocketAddr::from(([127, 0, 0, 1], address.port())) } else { address };
        Self { own, names: all, addresses, any_address }
    }

    /// Returns whether a value of `Host` denotes this server. Foreign names are refused, because they can be rebound to this
    /// computer; an address literal cannot.
    #[must_use]
    pub fn allows(&self, host: &str) -> bool {
        if let Ok(address) = host.parse::<SocketAddr>() {
            return address.port() == self.own.port() && (self.any_address || self.addresses.contains(&address.ip()));
        }
        let (name, port) = host.rsplit_once(':').unwrap_or((host, "80"));
        port.parse() == Ok(self.own.port()) && self.names.iter().any(|known| known.eq_ignore_ascii_case(name))
    }

    /// Address with which a browser of this computer reaches the server.
    #[must_use]
    pub const fn own(&self) -> SocketAddr {
        self.own
    }

    /// Returns the address to use instead of the name `localhost`; none for other names. `localhost` denotes two addresses: at the
    /// other one another program may listen, which would share the origin of the page.
    #[must_use]
    pub fn address_of(&self, host: &str) -> Option<SocketAddr> {
        let name = host.rsplit_once(':').map_or(host, |(name, _)| name);
        name.eq_ignore_ascii_case("localhost").then_some(self.own)
    }

    /// Returns whether a value of `Origin` is the origin of the page that was requested under `host`.
    #[must_use]
    pub fn is_origin(&self, origin: &str, host: &str) -> bool {
        self.allows(host)
            && (origin.strip_prefix("http://") == Some(host) || origin.strip_prefix("https://") == Some(host))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hosts(address: &str) -> Hosts {
        Hosts::new(address.parse().unwrap(), vec!["bench.local".to_owned()])
    }

    #[test]
    fn only_own_names_with_the_own_port_are_allowed() {
        let hosts = hosts("127.0.0.1:7410");
        for host in ["127.0.0.1:7410", "localhost:7410", "LOCALHOST:7410", "[::1]:7410", "bench.local:7410"] {
            assert!(hosts.allows(host), "{host}");
        }
        let foreign = [
            "evil.test",
            "evil.test:7410",
            "127.0.0.1",
            "127.0.0.1:80",
            "localhost.evil.test:7410",
            "192.168.1.2:7410",
            "",
            ":7410",
        ];
        for host in foreign {
            assert!(!hosts.allows(host), "{host}");
        }
    }

    #[test]
    fn server_on_all_addresses_allows_all_literals() {
        let hosts = hosts("0.0.0.0:7410");
        assert!(hosts.allows("192.168.1.2:7410"));
        assert!(!hosts.allows("192.168.1.2:80"));
        assert!(!hosts.allows("evil.test:7410"));
    }
}
