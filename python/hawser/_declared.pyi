VERSION: str
DIGEST: str
FUNCTIONS: list[str]
MEMBERS: dict[str, dict[str, str]]
