"""Where a study's members are run: in this process, on this machine's cores, or on a cluster by its address.

An engine lends an executor of the standard library's kind; see `handing_out` for how work reaches it.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from abc import ABC, abstractmethod
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from typing import Any

from dampen.component import ArgumentError
from dampen.studies.evaluate import Row, Work, evaluate


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
    """Processes of this machine, started afresh, each with one thread."""

    def __init__(self, workers: int | None = None):
        self.workers = workers or (len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)

    def __enter__(self) -> Cores:
        self.pool = ProcessPoolExecutor(self.workers, multiprocessing.get_context("spawn"), initializer=_begin)
        return self

    def __exit__(self, *_: object) -> None:
        self.pool.shutdown(cancel_futures=True)

    def submit(self, work: Work) -> Future[list[Row]]:
        return self.pool.submit(evaluate, work)

    def renew(self) -> None:
        self.pool.shutdown(wait=False, cancel_futures=True)
        self.__enter__()


class Cluster(Engine):
    """A running `dask.distributed` cluster, by the address of its scheduler; its workers need dampen installed."""

    def __init__(self, address: str):
        self.address = address

    def __enter__(self) -> Cluster:
        try:
            from distributed import Client
        except ImportError:
            raise ArgumentError("Option `--scheduler` needs dask.distributed: pip install 'dampen[cluster]'.") from None
        try:
            self.client: Any = Client(self.address, timeout=10, set_as_default=False)
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
    """A worker's first act: leave Ctrl-C to its master, one thread for linear algebra, and an end when the master ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    import scipy.linalg  # noqa: F401  (loaded first, so that the limit reaches its BLAS too)
    from threadpoolctl import threadpool_limits

    threadpool_limits(1)
    master = multiprocessing.parent_process()

    def end_with_master() -> None:
        assert master is not None
        master.join()
        os._exit(1)

    threading.Thread(target=end_with_master, daemon=True).start()
