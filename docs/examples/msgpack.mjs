// MessagePack, as much of it as Onika's protocol needs (../protocol.md). Plain Node 20, no packages.

export function pack(value) {
  if (value === null || value === undefined) return Buffer.from([0xc0]);
  if (typeof value === "boolean") return Buffer.from([value ? 0xc3 : 0xc2]);
  if (typeof value === "number") return number(value);
  if (typeof value === "string") return Buffer.concat([size(0xdb, Buffer.byteLength(value)), Buffer.from(value)]);
  if (Buffer.isBuffer(value)) return Buffer.concat([size(0xc6, value.length), value]);
  if (Array.isArray(value)) return Buffer.concat([size(0xdd, value.length), ...value.map(pack)]);
  const pairs = Object.entries(value).filter(([, item]) => item !== undefined);
  return Buffer.concat([size(0xdf, pairs.length), ...pairs.flat().map(pack)]);
}

function number(value) {
  const bytes = Buffer.alloc(9);
  if (Number.isSafeInteger(value)) {
    if (value >= 0 && value < 128) return Buffer.from([value]);
    bytes.writeBigInt64BE(BigInt(value), 1);
    bytes[0] = 0xd3;
  } else {
    bytes.writeDoubleBE(value, 1);
    bytes[0] = 0xcb;
  }
  return bytes;
}

function size(kind, length) {
  const bytes = Buffer.alloc(5, kind);
  bytes.writeUInt32BE(length, 1);
  return bytes;
}

export function unpack(bytes) {
  let at = 0;
  const take = (length) => {
    if (at + length > bytes.length) throw new Error("it ends too early");
    return bytes.subarray(at, (at += length));
  };
  const whole = (length) => (length === 8 ? Number(take(8).readBigUInt64BE()) : take(length).readUIntBE(0, length));
  const signed = (length) => (length === 8 ? Number(take(8).readBigInt64BE()) : take(length).readIntBE(0, length));
  const several = (length, item) => {
    if (length > bytes.length) throw new Error("more items than bytes");
    return Array.from({ length }, item);
  };
  const list = (length) => several(length, next);
  const map = (length) => Object.fromEntries(several(length, () => [next(), next()]));
  const text = (length) => take(length).toString("utf8");
  function next() {
    const kind = take(1)[0];
    if (kind < 0x80) return kind;
    if (kind < 0x90) return map(kind & 15);
    if (kind < 0xa0) return list(kind & 15);
    if (kind < 0xc0) return text(kind & 31);
    if (kind >= 0xe0) return kind - 256;
    if (kind >= 0xc4 && kind <= 0xc6) return Buffer.from(take(whole(1 << (kind - 0xc4))));
    if (kind >= 0xcc && kind <= 0xcf) return whole(1 << (kind - 0xcc));
    if (kind >= 0xd0 && kind <= 0xd3) return signed(1 << (kind - 0xd0));
    if (kind >= 0xd9 && kind <= 0xdb) return text(whole(1 << (kind - 0xd9)));
    if (kind === 0xc0) return null;
    if (kind === 0xc2 || kind === 0xc3) return kind === 0xc3;
    if (kind === 0xca) return take(4).readFloatBE();
    if (kind === 0xcb) return take(8).readDoubleBE();
    if (kind === 0xdc || kind === 0xdd) return list(whole(kind === 0xdc ? 2 : 4));
    if (kind === 0xde || kind === 0xdf) return map(whole(kind === 0xde ? 2 : 4));
    throw new Error(`no MessagePack of this protocol: 0x${kind.toString(16)}`);
  }
  const value = next();
  if (at !== bytes.length) throw new Error("something follows");
  return value;
}
