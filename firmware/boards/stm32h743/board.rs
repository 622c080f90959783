//! The chip with the clock configuration after reset: 64 MHz. The link is USART3: PD8 transmits, PD9 receives. The line for
//! monitors is USART2, with the feature `monitor`: PD5 transmits, PD6 receives.

#[cfg(not(feature = "monitor"))]
use bica_firmware::NoLine;
use bica_firmware::{Board, Links};
use cortex_m::peripheral::{DWT, SCB};
use embassy_stm32::usart::{BufferedInterruptHandler, BufferedUart, BufferedUartRx, BufferedUartTx, Config};
use embassy_stm32::{bind_interrupts, pac, peripherals};
use static_cell::ConstStaticCell;

bind_interrupts!(struct Interrupts {
    USART3 => BufferedInterruptHandler<peripherals::USART3>;
    #[cfg(feature = "monitor")]
    USART2 => BufferedInterruptHandler<peripherals::USART2>;
});

const BAUD: u32 = 921_600;
/// Size of each buffer of the serial port, bytes.
const BUFFER_BYTES: usize = 2048;

static RX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);
static TX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);

#[cfg(feature = "monitor")]
static MONITOR_RX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);
#[cfg(feature = "monitor")]
static MONITOR_TX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);

/// The board.
pub(crate) struct Stm32h743 {
    uart: BufferedUart<'static>,
    #[cfg(feature = "monitor")]
    monitor: BufferedUart<'static>,
}

impl Stm32h743 {
    /// Starts the board's peripherals. Called once.
    pub(crate) fn start() -> Self {
        let parts = embassy_stm32::init(embassy_stm32::Config::default());
        if let Some(mut core) = cortex_m::Peripherals::take() {
            core.DCB.enable_trace();
            core.DWT.enable_cycle_counter();
        }
        let mut config = Config::default();
        config.baudrate = BAUD;
        let (tx, rx) = (TX_BUFFER.take(), RX_BUFFER.take());
        let uart = BufferedUart::new(parts.USART3, parts.PD9, parts.PD8, tx, rx, Interrupts, config);
        #[cfg(feature = "monitor")]
        let (tx, rx) = (MONITOR_TX_BUFFER.take(), MONITOR_RX_BUFFER.take());
        #[cfg(feature = "monitor")]
        let monitor = BufferedUart::new(parts.USART2, parts.PD6, parts.PD5, tx, rx, Interrupts, config);
        Self {
            uart: uart.expect("the clock supports the baud rate"),
            #[cfg(feature = "monitor")]
            monitor: monitor.expect("the clock supports the baud rate"),
        }
    }
}

impl Board for Stm32h743 {
    type Rx = BufferedUartRx<'static>;
    type Tx = BufferedUartTx<'static>;
    #[cfg(feature = "monitor")]
    type MonitorRx = BufferedUartRx<'static>;
    #[cfg(feature = "monitor")]
    type MonitorTx = BufferedUartTx<'static>;
    #[cfg(not(feature = "monitor"))]
    type MonitorRx = NoLine;
    #[cfg(not(feature = "monitor"))]
    type MonitorTx = NoLine;
    const COUNTER_HZ: u32 = 64_000_000;

    fn links(self) -> Links<Self> {
        let (tx, rx) = self.uart.split();
        #[cfg(feature = "monitor")]
        let (monitor_tx, monitor_rx) = self.monitor.split();
        #[cfg(not(feature = "monitor"))]
        let (monitor_tx, monitor_rx) = (NoLine, NoLine);
        Links { body: (rx, tx), monitor: (monitor_rx, monitor_tx) }
    }

    fn counter() -> u32 {
        DWT::cycle_count()
    }

    fn write_blocking(bytes: &[u8]) {
        for &byte in bytes {
            while !pac::USART3.isr().read().txe() {}
            pac::USART3.tdr().write(|word| word.set_dr(byte.into()));
        }
        while !pac::USART3.isr().read().tc() {}
    }

    fn reset() -> ! {
        SCB::sys_reset()
    }
}
