"""What cffi makes: its types are known when it runs only."""
from typing import Any

class _FFI:
    CData: Any
    NULL: Any
    def __getattr__(self, name: str) -> Any: ...

ffi: _FFI
lib: Any
