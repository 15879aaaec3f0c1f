"""The walks of CONTRIBUTING.md lead through the code as it is: every stop names a function that its file has."""
import os
import re
import sys

root = os.environ["TAUT_SOURCE_DIR"]
with open(os.path.join(root, "CONTRIBUTING.md"), encoding="utf8") as page:
    stops = re.findall(r"^\| (\d+) \| `([^`]+)`: `(\w+)` \|", page.read(), re.M)

wrong = []
for number, path, function in stops:
    place = os.path.join(root, path)
    if not os.path.isfile(place):
        wrong.append(f"stop {number}: there is no {path}")
        continue
    with open(place, encoding="utf8") as code:
        # a definition, not a call: the name with its arguments at the head of a block
        if not re.search(rf"[\w>&*:] ?{function}\([^;{{]*\)[^;{{]*\{{", code.read().replace("::", " ")):
            wrong.append(f"stop {number}: {path} defines no {function}")
walks = [int(number) for number, _, _ in stops].count(1)
if walks != 2 or len(stops) > 15 + 8:
    wrong.append(f"{walks} walks with {len(stops)} stops; two of at most 15 and 8 are meant")
if wrong:
    sys.exit("\n".join(wrong))
