// A sentence with gaps, and how values fill them: the rules are those of src/onika/words/sentence.py.

export type Scalar = string | number | boolean
export type Value<T> = Scalar | T | readonly (Scalar | T)[]

const CONNECTIVES: Record<string, Record<string, string>> = { en: { and: 'and', or: 'or' }, es: { and: 'y', or: 'o' } }
const DECIMAL_SIGNS: Record<string, string> = { en: '.', es: ',' }
const LISTS = ['', 'and', 'or', ';']
const GAP = /\{\{|\}\}|\{(\w+)(?::([^{}]*))?\}/g
const NUMBER_FORMAT = /^(<?)(\+?)(\d*)(?:\.(\d+))?([gf])$/

/** The sentence with its gaps filled; `show` writes a value that is no text, number or list. Throws where one is missing. */
export function fill<T>(
  sentence: string,
  values: Readonly<Record<string, Value<T>>>,
  language: string,
  show: (value: T) => string = String,
): string {
  return sentence.replace(GAP, (gap: string, name?: string, rule: string = '') => {
    if (name === undefined) return gap[0]!
    const value = values[name]
    if (value === undefined) throw new RangeError(`expected a value of ${name}, found none`)
    return filled(value, rule, language, show)
  })
}

function filled<T>(value: Value<T>, rule: string, language: string, show: (value: T) => string): string {
  const [kind = '', forms = ''] = parted(rule, ':')
  if (kind === 'plural') {
    const [singular, plural] = parted(forms, '|')
    const count = isList(value) ? value.length : value
    return (count === 1 ? singular : plural) ?? ''
  }
  if (isList(value)) {
    const items = value.map((item) => filled(item, LISTS.includes(kind) ? '' : rule, language, show))
    const hasCommas = value.some((item, at) => typeof item === 'number' && items[at]!.includes(','))
    return listed(items, kind === ';' || hasCommas ? ';' : ',', CONNECTIVES[language]?.[kind] ?? '')
  }
  if (LISTS.includes(kind)) return written(value, language, show)
  if (kind === 'quoted') return quoted(written(value, language, show))
  const format = NUMBER_FORMAT.exec(kind)
  if (!format || typeof value !== 'number')
    throw new RangeError(`expected a rule of a gap that suits its value, found ${rule}`)
  const [, left, sign, width, digits, letter] = format
  const text = letter === 'f' ? value.toFixed(Number(digits ?? 6)) : general(value, Number(digits ?? 6))
  const signed = withSign(sign && value >= 0 ? `+${text}` : text, language)
  return left ? signed.padEnd(Number(width)) : signed.padStart(Number(width))
}

function isList<T>(value: Value<T>): value is readonly (Scalar | T)[] {
  return Array.isArray(value)
}

function parted(text: string, sign: string): [string, string] {
  const at = text.indexOf(sign)
  return at < 0 ? [text, ''] : [text.slice(0, at), text.slice(at + 1)]
}

function listed(items: readonly string[], sign: string, connective: string): string {
  const between = `${sign} `
  if (!connective || items.length < 2) return items.join(between)
  return `${items.slice(0, -1).join(between)} ${connective} ${items.at(-1)}`
}

/** A number as Python writes it, with the decimal sign of a language. */
const withSign = (number: string, language: string): string => number.replace('.', DECIMAL_SIGNS[language] ?? '.')

function written<T>(value: Scalar | T, language: string, show: (value: T) => string): string {
  if (typeof value === 'string') return value
  if (typeof value === 'boolean') return value ? 'True' : 'False'
  if (typeof value === 'number') return withSign(shortest(value), language)
  return show(value)
}

/** The fewest digits that mean this number, as Python's `repr` writes them. */
function shortest(value: number): string {
  const size = Math.abs(value)
  if (value === 0 || (size >= 1e-4 && size < 1e16)) return String(value)
  return twoDigits(value.toExponential())
}

/** Python's format `g` with so many digits. */
function general(value: number, digits: number): string {
  const precision = Math.max(1, digits)
  const [mantissa, exponent] = value.toExponential(precision - 1).split('e') as [string, string]
  const power = Number(exponent)
  if (power < -4 || power >= precision) return twoDigits(`${bare(mantissa)}e${exponent}`)
  return bare(value.toFixed(precision - 1 - power))
}

function bare(number: string): string {
  return number.includes('.') ? number.replace(/\.?0+$/, '') : number
}

function twoDigits(number: string): string {
  return number.replace(/e([+-])(\d)$/, 'e$10$2')
}

const ESCAPES: Record<string, string> = { '\\': '\\\\', '\n': '\\n', '\r': '\\r', '\t': '\\t' }

/** The text in quotes, as Python's `repr` writes it. */
function quoted(text: string): string {
  const quote = text.includes("'") && !text.includes('"') ? '"' : "'"
  const inner = text.replace(
    // eslint-disable-next-line no-control-regex -- these are what is escaped
    /[\\\u0000-\u001f\u007f-\u00a0\u00ad]/g,
    (sign) => ESCAPES[sign] ?? `\\x${sign.charCodeAt(0).toString(16).padStart(2, '0')}`,
  )
  return quote + (quote === "'" ? inner.replaceAll("'", "\\'") : inner) + quote
}
