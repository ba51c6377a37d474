"""What a run of vug may end with, by its exit codes."""


class VugError(Exception):
    """A call of vug that failed; `exit_code` as in the README, the text is the line that vug has said."""

    exit_code = 1


class CaseError(VugError, ValueError):
    """The case or the command line is invalid; nothing was written."""

    exit_code = 2


class Diverged(VugError, ArithmeticError):
    """The run diverged; its last good checkpoint is named."""

    exit_code = 3


class FileTrouble(VugError, OSError):
    """Reading or writing a file failed."""

    exit_code = 4


class OutOfMemory(VugError, MemoryError):
    """The case needs more memory than there is."""

    exit_code = 5


class Interrupted(VugError):
    """The run was stopped by a signal, after it had written a checkpoint."""

    exit_code = 130


class VugWarning(UserWarning):
    """What vug has warned of, for instance a number outside the range in which it was found safe."""


BY_CODE = {error.exit_code: error for error in (CaseError, Diverged, FileTrouble, OutOfMemory, Interrupted)}


def text_of(path, **options):
    """What a text file holds, UTF-8. Raises FileTrouble, with its path, where it is lost or cannot be read."""
    try:
        with open(path, encoding="utf-8", **options) as file:
            return file.read()
    except OSError as error:
        raise FileTrouble(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise FileTrouble(f"{path}: is no UTF-8 text: {error.reason}") from None
