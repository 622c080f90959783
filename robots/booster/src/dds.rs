//! The robot's topics by DDS.

use std::net::{IpAddr, Ipv4Addr};

use rustdds::no_key::{DataReader, DataSample, DataWriter};
use rustdds::policy::{DataRepresentation, Durability, History, Reliability, XCDR_DATA_REPRESENTATION};
use rustdds::serialization::{CDRDeserializerAdapter, CDRSerializerAdapter};
use rustdds::{
    DomainParticipant, DomainParticipantBuilder, Duration, QosPolicies, QosPolicyBuilder, ReadCondition, Topic,
    TopicKind,
};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::message::{FallDownState, LowCmd, LowState, RpcReqMsg, RpcRespMsg};
use crate::transport::{Received, Transport};

/// Most messages of a topic that are taken at once.
const MOST: usize = 64;
/// Longest time for which a reliable writer waits for room.
const BLOCKING: Duration = Duration::from_millis(5);

type Reader<T> = DataReader<T, CDRDeserializerAdapter<T>>;
type Writer<T> = DataWriter<T, CDRSerializerAdapter<T>>;

/// Reader and writer of the robot's topics.
pub struct Dds {
    states: Reader<LowState>,
    falls: Reader<FallDownState>,
    answers: Reader<RpcRespMsg>,
    commands: Writer<LowCmd>,
    requests: Writer<RpcReqMsg>,
    /// Ends last.
    _participant: DomainParticipant,
}

impl Dds {
    /// Joins a domain, 0 on the robot, on the network of one address of this computer, or on all.
    ///
    /// # Errors
    /// If sockets, threads or topics cannot be made.
    pub fn open(domain: u16, address: Option<IpAddr>) -> Result<Self, String> {
        let mut builder = DomainParticipantBuilder::new(domain);
        if let Some(address) = address {
            builder = builder.with_only_networks([address]);
            // A robot is another computer: what stays on this one is asked for by its address.
            builder = builder.same_host_loopback(address.is_loopback());
        }
        let participant = builder.build().map_err(|error| format!("no DDS participant: {error}"))?;
        let open = Open(participant);
        let interface = "booster_interface::msg::dds_";
        let service = "booster_msgs::msg::dds_";
        // As the writers of the maker's wheel: a reader of the robot may ask for it.
        let written = reliable(Durability::TransientLocal, 1);
        let answered = reliable(Durability::Volatile, 16);
        Ok(Self {
            states: open.reader("rt/low_state", &format!("{interface}::LowState_"), &newest())?,
            falls: open.reader("rt/fall_down", &format!("{interface}::FallDownState_"), &newest())?,
            answers: open.reader("rt/LocoApiTopicResp", &format!("{service}::RpcRespMsg_"), &answered)?,
            commands: open.writer("rt/joint_ctrl", &format!("{interface}::LowCmd_"), &written)?,
            requests: open.writer("rt/LocoApiTopicReq", &format!("{service}::RpcReqMsg_"), &written)?,
            _participant: open.0,
        })
    }
}

/// Messages may be lost, and only the newest one is kept.
fn newest() -> QosPolicies {
    let builder = QosPolicyBuilder::new().reliability(Reliability::BestEffort).durability(Durability::Volatile);
    plain(builder.history(History::KeepLast { depth: 1 }).build())
}

fn reliable(durability: Durability, depth: i32) -> QosPolicies {
    let reliability = Reliability::Reliable { max_blocking_time: BLOCKING };
    let builder = QosPolicyBuilder::new().reliability(reliability).durability(durability);
    plain(builder.history(History::KeepLast { depth }).build())
}

/// With the first version of the encoding.
fn plain(qos: QosPolicies) -> QosPolicies {
    qos.with_data_representation(DataRepresentation { value: vec![XCDR_DATA_REPRESENTATION] })
}

struct Open(DomainParticipant);

impl Open {
    fn topic(&self, name: &str, of: &str, qos: &QosPolicies) -> Result<Topic, String> {
        let topic = self.0.create_topic(name.to_owned(), of.to_owned(), qos, TopicKind::NoKey);
        topic.map_err(|error| format!("no topic {name}: {error}"))
    }

    fn reader<T: DeserializeOwned + 'static>(
        &self,
        name: &str,
        of: &str,
        qos: &QosPolicies,
    ) -> Result<Reader<T>, String> {
        let topic = self.topic(name, of, qos)?;
        let subscriber = self.0.create_subscriber(qos).map_err(|error| format!("no subscriber: {error}"))?;
        let reader = subscriber.create_datareader_no_key(&topic, Some(qos.clone()));
        reader.map_err(|error| format!("no reader of {name}: {error}"))
    }

    fn writer<T: Serialize>(&self, name: &str, of: &str, qos: &QosPolicies) -> Result<Writer<T>, String> {
        let topic = self.topic(name, of, qos)?;
        let publisher = self.0.create_publisher(qos).map_err(|error| format!("no publisher: {error}"))?;
        let writer = publisher.create_datawriter_no_key(&topic, Some(qos.clone()));
        writer.map_err(|error| format!("no writer of {name}: {error}"))
    }
}

/// Takes what has come; a message that cannot be read is left out.
fn take<T: DeserializeOwned + 'static>(reader: &mut Reader<T>) -> Vec<T> {
    let mut taken = Vec::new();
    for _ in 0..MOST {
        match reader.take(MOST, ReadCondition::not_read()) {
            Ok(samples) if samples.is_empty() => break,
            Ok(samples) => taken.extend(samples.into_iter().map(DataSample::into_value)),
            Err(_) => {}
        }
        if taken.len() >= MOST {
            break;
        }
    }
    taken
}

impl Transport for Dds {
    fn receive(&mut self) -> Received {
        Received { states: take(&mut self.states), fall: take(&mut self.falls).pop(), answers: take(&mut self.answers) }
    }

    fn command(&mut self, command: LowCmd) {
        // The next command replaces one that cannot be sent.
        _ = self.commands.write(command, None);
    }

    fn request(&mut self, request: RpcReqMsg) {
        // A request without an answer is made again.
        _ = self.requests.write(request, None);
    }
}

/// Returns the address of a network interface of this computer, given by its name or by the address itself.
///
/// # Errors
/// If there is no such interface, or it has no IPv4 address.
pub fn address(interface: &str) -> Result<IpAddr, String> {
    if let Ok(address) = interface.parse::<Ipv4Addr>() {
        return Ok(address.into());
    }
    of_name(interface).ok_or_else(|| format!("no network interface `{interface}` with an IPv4 address"))
}

#[cfg(unix)]
fn of_name(interface: &str) -> Option<IpAddr> {
    let mut all = nix::ifaddrs::getifaddrs().ok()?.filter(|one| one.interface_name == interface);
    all.find_map(|one| Some(one.address?.as_sockaddr_in()?.ip().into()))
}

/// Names are looked up on Unix only.
#[cfg(not(unix))]
fn of_name(_interface: &str) -> Option<IpAddr> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interfaces_have_names_and_addresses() {
        assert_eq!(address("192.168.10.102"), Ok(Ipv4Addr::new(192, 168, 10, 102).into()));
        #[cfg(target_os = "linux")]
        assert_eq!(address("lo"), Ok(Ipv4Addr::LOCALHOST.into()));
        assert!(address("nowhere0").is_err_and(|error| error.contains("nowhere0")));
    }
}
