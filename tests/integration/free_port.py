"""A port to listen on."""
import random
import socket


def free_port():
    """Below those that the system gives to connections, which could take it while the coordinator is dead."""
    while True:
        with socket.socket() as s:
            try:
                s.bind(('127.0.0.1', random.SystemRandom().randrange(15000, 32000)))
                return s.getsockname()[1]
            except OSError:
                pass
