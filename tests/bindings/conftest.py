"""What the Python binding's tests share."""
import pytest
import ups


@pytest.fixture(scope="module")
def context():
    return ups.Context(thread_count=2)
