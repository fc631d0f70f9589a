// Español: por qué no se puede cambiar algo en una aplicación o en un diccionario (desk/upper/flow, desk/upper/dictionary).
// Todo lo que allí se niega está aquí; una prueba lo comprueba.
export const esHeardEdit: readonly (readonly [RegExp, string])[] = [
  // lo que ya no está
  [/^there is nothing to take back$/, 'no hay nada que deshacer'],
  [/^there is nothing to do again$/, 'no hay nada que rehacer'],
  // insertar, mover, copiar
  [/^(.+) is (.+), which stands in no flow$/, '{0} es {1}, que no va en ningún flujo'],
  // bifurcaciones y flujos
  [/^an application has (.+) flows, not (.+)$/, 'una aplicación tiene de {0} flujos, no {1}'],
  // archivos
  [
    /^there are no types of icons: the definition (.+) could not be read$/,
    'no hay tipos de iconos: no se pudo leer la definición {0}',
  ],
  [/^(.+) has no file yet$/, '{0} aún no tiene archivo'],
  [
    /^it has no file yet: give it a name and a base directory$/,
    'aún no tiene archivo: dele un nombre y un directorio base',
  ],
  [/^what could not be read of (.+) would be lost: ([^]+)$/, 'se perdería lo que no se pudo leer de {0}: {=1}'],
  [/^(.+) cannot be saved: ([^]+)$/, '{0} no se puede guardar: {=1}'],
  [/^(.+) is not saved$/, '{0} no está guardada'],
  [/^(.+) is no file$/, '{0} no es un archivo'],
  [/^there is no file (.+)$/, 'no hay ningún archivo {0}'],
  [
    /^(.+) is no name of an application: expected letters, digits and _ \. -, a letter first$/,
    '{0} no sirve como nombre de aplicación: se esperan letras, cifras y _ . -, primero una letra',
  ],
  [/^(.+) is no name for a file$/, '{0} no sirve como nombre de archivo'],
  [/^(.+) would be part of Onika itself there$/, '{0} formaría allí parte de Onika misma'],
  // diccionarios
  [/^(.+) cannot be opened: ([^]+)$/, '{0} no se puede abrir: {=1}'],
]
