"""What the Python binding's tests share."""
import os
import sys

import pytest
import ups

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))


@pytest.fixture(scope="module")
def context():
    return ups.Context(thread_count=2)
