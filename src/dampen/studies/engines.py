"""Where a study's members are run: in this process, on this machine's cores, or on a cluster by its address.

An engine lends an executor of the standard library's kind; see `handing_out` for how work reaches it.
"""

from __future__ import annotations

import os
import signal
import threading
import time
from abc import ABC, abstractmethod
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from typing import Any

from dampen.component import ArgumentError
from dampen.simulation.cores import cores
from dampen.studies.evaluate import Row, Work, evaluate

SCHEMES = ("tcp", "tls", "ws", "wss", "ucx", "ucxx", "inproc")


class Engine(ABC):
    """Lends an executor with a number of workers; `renew` after a worker has died."""

    workers: int

    @abstractmethod
    def __enter__(self) -> Engine: ...

    @abstractmethod
    def __exit__(self, *_: object) -> None: ...

    @abstractmethod
    def submit(self, work: Work) -> Future[list[Row]]:
        """Hand out a piece of work."""

    def renew(self) -> None:  # noqa: B027  (most heal by themselves)
        """Be ready again after a worker has died."""

    def lost(self, error: BaseException) -> bool:
        """Whether an error means that the worker was lost, and not that the work is wrong."""
        return isinstance(error, BrokenExecutor)


class Here(Engine):
    """This process: for scenarios that no other process can make, such as those with classes from a notebook."""

    workers = 1

    def __enter__(self) -> Here:
        self.pool: Executor = ThreadPoolExecutor(1)
        return self

    def __exit__(self, *_: object) -> None:
        self.pool.shutdown()

    def submit(self, work: Work) -> Future[list[Row]]:
        return self.pool.submit(evaluate, work)


class Cores(Engine):
    """Processes of this machine, started afresh, each with one thread.

    loky's, since they do not run the caller's script again: no `if __name__ == "__main__"` is asked of it.
    """

    def __init__(self, workers: int | None = None):
        self.workers = workers or cores()

    def __enter__(self) -> Cores:
        from loky import ProcessPoolExecutor

        self.pool: Any = ProcessPoolExecutor(self.workers, initializer=_begin)
        return self

    def __exit__(self, *_: object) -> None:
        self.pool.shutdown(kill_workers=True)

    def submit(self, work: Work) -> Future[list[Row]]:
        future: Future[list[Row]] = self.pool.submit(evaluate, work)
        return future

    def renew(self) -> None:
        self.__exit__()
        self.__enter__()


class Cluster(Engine):
    """A running `dask.distributed` cluster, by the address of its scheduler; its workers need dampen installed."""

    def __init__(self, address: str):
        self.address = address

    def __enter__(self) -> Cluster:
        try:
            import distributed
        except ImportError:
            raise ArgumentError("Option `--scheduler` needs dask.distributed: pip install 'dampen[cluster]'.") from None
        if self.address.partition("://")[0] not in SCHEMES:
            raise ArgumentError(
                f"Option `--scheduler` must be the address of a running scheduler, tcp://..., but is {self.address!r}."
            )
        try:
            client: Any = distributed.Client
            self.client: Any = client(self.address, timeout=10, set_as_default=False)
        except Exception as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise ArgumentError(f"Option `--scheduler` must be the address of a running scheduler: {reason}.") from None
        self.workers = max(1, sum(self.client.nthreads().values()))
        self.pool = self.client.get_executor(pure=False)
        return self

    def __exit__(self, *_: object) -> None:
        self.pool.shutdown(wait=False)
        self.client.close()

    def submit(self, work: Work) -> Future[list[Row]]:
        future: Future[list[Row]] = self.pool.submit(evaluate, work)
        return future

    def lost(self, error: BaseException) -> bool:
        return type(error).__name__ in ("KilledWorker", "CommClosedError", "CancelledError")


def _begin() -> None:
    """A worker's first act: leave Ctrl-C to its master, and end when the master ends, however that ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    master = os.getppid()

    def end_with_master() -> None:
        while os.getppid() == master:
            time.sleep(0.5)
        os._exit(1)

    threading.Thread(target=end_with_master, daemon=True).start()
