"""Exchange of numbers with another program over TCP/IP, e.g. for co-simulation."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from dalembert._core import Print

if TYPE_CHECKING:
    import socket


class TCPIPdata:
    """An open connection: how many doubles go each way, how they are packed, and the sockets."""

    def __init__(
        self,
        sendSize: int,
        receiveSize: int,
        packerSend: struct.Struct,
        packerReceive: struct.Struct,
        socketTCP: socket.socket,
        connection: socket.socket,
        address: Any,
        lastReceiveTime: float,
    ) -> None:
        self.sendSize, self.receiveSize = sendSize, receiveSize
        self.packerSend, self.packerReceive = packerSend, packerReceive
        self.socket, self.connection, self.address = socketTCP, connection, address
        self.lastReceiveTime = lastReceiveTime  # s; free for the user


def CreateTCPIPconnection(
    sendSize: int,
    receiveSize: int,
    IPaddress: str = "127.0.0.1",
    port: int = 52421,
    bigEndian: bool = False,
    verbose: bool = False,
) -> TCPIPdata:
    """Wait for another program to connect to address and port; sizes are numbers of doubles per message."""
    import socket  # here, as all models import this file and few need connections

    order = ">" if bigEndian else "<"
    if verbose:
        Print(f"waiting for a TCP/IP connection to {IPaddress}:{port}")
    server = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        server.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        server.bind((IPaddress, port))
        server.listen()
        connection, address = server.accept()
    except BaseException:
        server.close()
        raise
    if verbose:
        Print(f"TCP/IP connection from {address}")
    send, receive = struct.Struct(f"{order}{sendSize}d"), struct.Struct(f"{order}{receiveSize}d")
    return TCPIPdata(sendSize, receiveSize, send, receive, server, connection, address, 0.0)


def TCPIPsendReceive(TCPIPobject: TCPIPdata, sendData: Sequence[float]) -> tuple[float, ...]:
    """Send sendSize numbers, wait for receiveSize numbers and return them; zeros if the other side has closed."""
    TCPIPobject.connection.sendall(TCPIPobject.packerSend.pack(*sendData))
    received = b""
    while len(received) < TCPIPobject.packerReceive.size:
        part = TCPIPobject.connection.recv(TCPIPobject.packerReceive.size - len(received))
        if not part:
            Print("WARNING: TCPIPsendReceive: the other side has closed the connection")
            return (0.0,) * TCPIPobject.receiveSize
        received += part
    return tuple(TCPIPobject.packerReceive.unpack(received))


def CloseTCPIPconnection(TCPIPobject: TCPIPdata) -> None:
    """Close the connection and its socket."""
    TCPIPobject.connection.close()
    TCPIPobject.socket.close()
