//! The node in the network: its publishers and their listeners.

use std::collections::{BTreeMap, BTreeSet};
use std::net::Ipv4Addr;

use bica_recording::ros::{Encoded, Kind, Names, Quality, Ros, Sent, Topic};
use bica_wire::model::Invalid;
use ros2_client::dds::rustdds::{DomainParticipantBuilder, DomainParticipantStatusEvent, GUID, StatusEvented as _};
use ros2_client::dds::{Context, Node, Publisher, Server, ServiceMapping, Subscription, rustdds};
use ros2_client::qos::{Durability, History, Reliability, WhenFull};
use ros2_client::{Message, MessageTypeName, Name, NodeName, NodeOptions, QosProfile, ServiceTypeName};

use super::Options;

/// Maximum number of messages that wait for a slow node.
const DEPTH: usize = 10;

/// The node in the network.
pub(super) struct Network {
    node: Node,
    listener: rustdds::DomainParticipantStatusListener,
    mapping: ServiceMapping,
    publishers: Vec<Publisher<Encoded>>,
    /// Index of each publisher's topic.
    writers: BTreeMap<GUID, usize>,
    /// Nodes that listen to each topic.
    readers: BTreeMap<usize, BTreeSet<GUID>>,
}

impl Network {
    /// Joins the domain.
    pub(super) fn join(options: &Options, names: &Names) -> Result<Self, Invalid> {
        let mut participant = DomainParticipantBuilder::new(options.domain);
        if !options.anywhere {
            participant = participant.with_only_networks([Ipv4Addr::LOCALHOST]);
        }
        let participant = participant.build().map_err(|error| failed(options.domain, &error))?;
        let context = Context::from_domain_participant(participant).map_err(|error| failed(options.domain, &error))?;
        let name = NodeName::new(&names.namespace, &names.node);
        let name = name.map_err(|error| {
            let help = "use letters, digits and single underscores, with a letter first";
            Invalid::new(format!("`{}` is not a namespace of ROS: {error}", names.namespace), help)
        })?;
        // This crate serves parameters and log itself: they are those of the tree.
        let own = NodeOptions::new().enable_rosout(false).start_parameter_services(false);
        let node = context.new_node(name, own).map_err(|error| failed(options.domain, &error))?;
        let listener = context.domain_participant().status_listener();
        let is_cyclone = std::env::var("RMW_IMPLEMENTATION").is_ok_and(|name| name == "rmw_cyclonedds_cpp");
        let mapping = if is_cyclone { ServiceMapping::Cyclone } else { ServiceMapping::Enhanced };
        let (publishers, writers, readers) = (Vec::new(), BTreeMap::new(), BTreeMap::new());
        Ok(Self { node, listener, mapping, publishers, writers, readers })
    }

    /// Adds a topic that the robot sends; it has the next index.
    pub(super) fn publish(&mut self, Topic { name, kind, quality, .. }: &Topic) -> Result<(), Invalid> {
        let topic = self.topic(name, *kind, &qos(*quality))?;
        let publisher = self.node.create_publisher(&topic, None).map_err(|error| refused(name, &error))?;
        self.writers.insert(publisher.guid(), self.publishers.len());
        self.publishers.push(publisher);
        Ok(())
    }

    /// Subscribes to a topic.
    pub(super) fn subscribe<M: Ros + 'static>(&mut self, name: &str) -> Result<Subscription<M>, Invalid> {
        let topic = self.topic(name, Kind::of::<M>(), &qos(Quality::Sensor))?;
        self.node.create_subscription(&topic, None).map_err(|error| refused(name, &error))
    }

    fn topic(&self, name: &str, kind: Kind, qos: &QosProfile) -> Result<rustdds::Topic, Invalid> {
        let parsed = Name::parse(name).map_err(|error| refused(name, &error))?;
        let kind = MessageTypeName::new(kind.package, kind.name);
        self.node.create_topic(&parsed, kind, qos).map_err(|error| refused(name, &error))
    }

    /// Offers a service of a type `package/Name`.
    pub(super) fn serve<Q, A>(&mut self, name: &str, (package, kind): (&str, &str)) -> Result<Server<Q, A>, Invalid>
    where
        Q: Message + Clone + 'static,
        A: Message + 'static,
    {
        let parsed = Name::parse(name).map_err(|error| refused(name, &error))?;
        let (qos, kind) = (qos(Quality::Reliable), ServiceTypeName::new(package, kind));
        let server = self.node.create_server(self.mapping, &parsed, &kind, qos.clone(), qos);
        server.map_err(|error| refused(name, &error))
    }

    /// Sends messages. A node that does not read its own loses them.
    pub(super) fn send(&self, messages: Vec<Sent>) {
        for (topic, message) in messages {
            // Without room the message is lost, like that of a best-effort topic: a slow node does not delay the others.
            let _ = self.publishers.get(topic).map(|publisher| publisher.publish(message));
        }
    }

    /// Returns the topics that have gained the first listener or lost the last one, and whether they have listeners.
    pub(super) fn changed_listeners(&mut self) -> BTreeMap<usize, bool> {
        let mut changed = BTreeMap::new();
        while let Some(event) = self.listener.try_recv_status() {
            match event {
                DomainParticipantStatusEvent::RemoteReaderMatched { local_writer, remote_reader } => {
                    if let Some(&topic) = self.writers.get(&local_writer)
                        && self.readers.entry(topic).or_default().insert(remote_reader)
                    {
                        changed.insert(topic, true);
                    }
                }
                DomainParticipantStatusEvent::ReaderLost { guid, .. } => {
                    for (topic, readers) in self.readers.iter_mut().filter(|(_, readers)| !readers.is_empty()) {
                        if readers.remove(&guid) && readers.is_empty() {
                            changed.insert(*topic, false);
                        }
                    }
                }
                _ => {}
            }
        }
        changed
    }

    /// Returns whether a topic has listeners.
    pub(super) fn is_heard(&self, topic: usize) -> bool {
        self.readers.get(&topic).is_some_and(|readers| !readers.is_empty())
    }
}

fn qos(quality: Quality) -> QosProfile {
    let reliable = Reliability::Reliable { when_full: WhenFull::Fail };
    let (reliability, durability, depth) = match quality {
        Quality::Sensor => (Reliability::BestEffort, Durability::Volatile, DEPTH),
        Quality::Reliable => (reliable, Durability::Volatile, DEPTH),
        Quality::Latched => (reliable, Durability::TransientLocal, 1),
    };
    QosProfile::default().reliability(reliability).durability(durability).history(History::KeepLast { depth })
}

fn failed(domain: u16, error: &dyn std::fmt::Display) -> Invalid {
    let help =
        "is there a network interface, and are the UDP ports of the domain free? choose another one with --ros-domain";
    Invalid::new(format!("cannot join the ROS domain {domain}: {error}"), help)
}

fn refused(name: &str, error: &dyn std::fmt::Display) -> Invalid {
    Invalid::new(
        format!("the topic or service `{name}` cannot be made: {error}"),
        "report it: this is an error of BICA",
    )
}
