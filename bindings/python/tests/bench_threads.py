#!/usr/bin/python3
"""How much two threads that share a detector get done in the time of one: bench_threads.py [ROUNDS]

Two processes do the same work beside them: what they reach is all that the machine has to give at that moment."""

import multiprocessing
import statistics
import sys
import threading
import time

import runmark

FRAMES = 60


def work(detector, images):
    for i in range(FRAMES):
        detector.detect(images[i % len(images)])


def seconds_of(runners):
    start = time.perf_counter()
    for runner in runners:
        runner.start()
    for runner in runners:
        runner.join()
    return time.perf_counter() - start


def process_main(images, start, done):
    detector = runmark.Detector("tag36h11")
    work(detector, images)
    while start.get():
        work(detector, images)
        done.put(True)


class Process:
    """A process that waits, ready, for its turn."""

    def __init__(self, images):
        self._go, self._done = multiprocessing.SimpleQueue(), multiprocessing.SimpleQueue()
        self._process = multiprocessing.Process(target=process_main, args=(images, self._go, self._done), daemon=True)
        self._process.start()

    def start(self):
        self._go.put(True)

    def join(self):
        self._done.get()


def measure(rounds):
    """[(speed-up of two threads, of two processes)], a pair for each round."""
    images = [runmark.render("hd", i)[0] for i in range(4)]
    processes = [Process(images) for _ in range(2)]
    detector = runmark.Detector("tag36h11")

    def thread():
        return threading.Thread(target=work, args=(detector, images))

    seconds_of([thread(), thread()])
    seconds_of(processes)
    pairs = []
    for _ in range(rounds):
        one = seconds_of([thread()])
        two = seconds_of([thread(), thread()])
        apart_one = seconds_of(processes[:1])
        apart_two = seconds_of(processes)
        pairs.append((2 * one / two, 2 * apart_one / apart_two))
    return pairs


def main():
    pairs = measure(int(sys.argv[1]) if len(sys.argv) > 1 else 9)
    for name, values in zip(("threads", "processes"), zip(*pairs)):
        print(f"two {name}: {statistics.median(values):.2f}x the work of one "
              f"(median of {len(values)} rounds, best {max(values):.2f}x)")


if __name__ == "__main__":
    main()
