//! Access tokens.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use dobot_api::{Role, write_private};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The accepted tokens of a station: the file `tokens.toml`, which contains only their digests.
///
/// ```
/// use dobot_api::{Role, write_private};
/// use dobot_station::Tokens;
///
/// let folder = tempfile::tempdir()?;
/// let mut tokens = Tokens::open(&folder.path().join("tokens.toml"))?;
/// let token = tokens.add(Role::Control, "plotter")?;
/// assert_eq!(token.secret().len(), 64);
/// assert_eq!(tokens.list().collect::<Vec<_>>(), [("plotter", Role::Control)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Tokens {
    file: PathBuf,
    version: Option<Version>,
    known: Vec<Known>,
    /// The number of changes.
    changes: u64,
    /// The token of local programs, which is not in the file.
    local: Option<[u8; 32]>,
}

impl Tokens {
    /// Reads the file; without a file, no token is accepted.
    ///
    /// # Errors
    ///
    /// [`TokensError`] if it cannot be read or parsed.
    pub fn open(file: &Path) -> Result<Self, TokensError> {
        let mut tokens = Self {
            file: file.to_owned(),
            version: None,
            known: Vec::new(),
            changes: 0,
            local: None,
        };
        tokens.follow()?;
        Ok(tokens)
    }

    /// Creates a token of 256 random bits. Only its digest is stored, so the token can be shown
    /// only now.
    ///
    /// # Errors
    ///
    /// [`TokensError`] if the name is used or invalid, or the file cannot be written.
    pub fn add(&mut self, role: Role, name: &str) -> Result<Token, TokensError> {
        let token = Token::random().map_err(TokensError::Random)?;
        self.accept(role, name, &token)?;
        Ok(token)
    }

    /// Accepts a token that another station has created, so that its holder is known to both.
    ///
    /// # Errors
    ///
    /// As with [`add`](Self::add), and [`TokensError::Known`] if the token is already accepted.
    pub fn accept(&mut self, role: Role, name: &str, token: &Token) -> Result<(), TokensError> {
        self.follow()?;
        if !is_name(name) {
            return Err(TokensError::Name(name.into()));
        }
        if self.known.iter().any(|token| token.name == name) {
            return Err(TokensError::Taken(name.into()));
        }
        let sha256 = hex(&digest(token.secret()));
        if let Some(same) = self.known.iter().find(|token| token.sha256 == sha256) {
            return Err(TokensError::Known(same.name.clone()));
        }
        self.known.push(Known {
            name: name.into(),
            role,
            shared: false,
            sha256,
            #[cfg(feature = "proofs")]
            key: Some(crate::http::proofs::public_key(token.secret())),
            #[cfg(not(feature = "proofs"))]
            key: None,
        });
        self.write()
    }

    /// Marks a token as shared by several people: each is identified by the name that they give.
    /// Any other token belongs to one person, identified by its name.
    ///
    /// # Errors
    ///
    /// [`TokensError`] if there is no token of that name, or the file cannot be written.
    pub fn share(&mut self, name: &str) -> Result<(), TokensError> {
        self.follow()?;
        let found = self.known.iter_mut().find(|token| token.name == name);
        let known = found.ok_or_else(|| TokensError::Unknown(name.into()))?;
        known.shared = true;
        self.write()
    }

    /// Whether the token of that name is shared by several people.
    #[must_use]
    pub fn is_shared(&self, name: &str) -> bool {
        self.known
            .iter()
            .any(|token| token.name == name && token.shared)
    }

    /// Whether this is the token of local programs.
    pub(crate) fn is_local(&self, token: &[u8; 32]) -> bool {
        self.local.is_some_and(|local| same(&local, token))
    }

    /// Removes a token, which is refused from then on.
    ///
    /// # Errors
    ///
    /// [`TokensError`] if there is no token of that name, or the file cannot be written.
    pub fn remove(&mut self, name: &str) -> Result<(), TokensError> {
        self.follow()?;
        let before = self.known.len();
        self.known.retain(|token| token.name != name);
        if self.known.len() == before {
            return Err(TokensError::Unknown(name.into()));
        }
        self.write()
    }

    /// Returns the names and roles of all tokens.
    pub fn list(&self) -> impl Iterator<Item = (&str, Role)> {
        self.known.iter().map(|token| (&*token.name, token.role))
    }

    /// Creates the token of local programs.
    pub(crate) fn make_local(&mut self) -> Result<Token, TokensError> {
        let token = Token::random().map_err(TokensError::Random)?;
        self.local = Some(digest(token.secret()));
        Ok(token)
    }

    /// Returns a copy of the file's state, to be read again without blocking requests for tokens.
    pub(crate) fn source(&self) -> TokensFile {
        TokensFile {
            file: self.file.clone(),
            version: self.version,
        }
    }

    /// Applies the contents of the file; while it is invalid, none of its tokens is accepted.
    pub(crate) fn apply(&mut self, read: Result<Option<TokensRead>, TokensError>) {
        match read {
            Ok(None) => {}
            Ok(Some(read)) => self.set(read.version, read.known),
            Err(_) if self.known.is_empty() => self.version = None,
            Err(_) => self.set(None, Vec::new()),
        }
    }

    /// Returns the number of changes: after a change admitted callers must be checked again.
    pub(crate) const fn changes(&self) -> u64 {
        self.changes
    }

    fn set(&mut self, version: Option<Version>, known: Vec<Known>) {
        (self.version, self.known) = (version, known);
        self.changes += 1;
    }

    /// Returns name and role of the token with this digest, as last read.
    pub(crate) fn known(&self, token: &[u8; 32]) -> Option<(String, Role)> {
        if self.local.is_some_and(|local| same(&local, token)) {
            return Some(("local program".into(), Role::Admin));
        }
        let digest = hex(token);
        let found = self.known.iter().fold(None, |found, token| {
            if same(token.sha256.as_bytes(), digest.as_bytes()) {
                Some(token)
            } else {
                found
            }
        });
        found.map(|token| (token.name.clone(), token.role))
    }

    /// Returns the digest of the token that this proof is made with, as last read.
    #[cfg(feature = "proofs")]
    pub(crate) fn proved(&self, statement: &[u8], proof: &[u8]) -> Option<[u8; 32]> {
        let is_proved = |token: &&Known| {
            let key = token.key.as_deref();
            key.is_some_and(|key| crate::http::proofs::is_proved(key, statement, proof))
        };
        let known = self.known.iter().find(is_proved)?;
        let digest = data_encoding::HEXLOWER.decode(known.sha256.as_bytes());
        digest.ok()?.try_into().ok()
    }

    /// Reads the file if it has changed.
    pub(crate) fn follow(&mut self) -> Result<(), TokensError> {
        if let Some(read) = self.source().read()? {
            self.set(read.version, read.known);
        }
        Ok(())
    }

    fn write(&mut self) -> Result<(), TokensError> {
        let content = Content {
            token: self.known.clone(),
        };
        let text = toml::to_string(&content).expect("a list of tables of texts is TOML");
        write_private(&self.file, &text).map_err(|error| self.io(error))?;
        self.version = Version::of(&self.file).map_err(|error| self.io(error))?;
        self.changes += 1;
        Ok(())
    }

    fn io(&self, source: io::Error) -> TokensError {
        TokensError::io(&self.file, source)
    }
}

/// The state of the file when it was last read.
#[derive(Debug)]
pub(crate) struct TokensFile {
    file: PathBuf,
    version: Option<Version>,
}

/// The parsed contents of the file.
#[derive(Debug)]
pub(crate) struct TokensRead {
    version: Option<Version>,
    known: Vec<Known>,
}

impl TokensFile {
    /// Returns the contents if the file has changed.
    pub(crate) fn read(&self) -> Result<Option<TokensRead>, TokensError> {
        let io = |error| TokensError::io(&self.file, error);
        let version = Version::of(&self.file).map_err(io)?;
        if version == self.version {
            return Ok(None);
        }
        let mut text = String::new();
        if version.is_some() {
            text = fs::read_to_string(&self.file).map_err(io)?;
        }
        let content: Content = toml::from_str(&text).map_err(|error| TokensError::Content {
            file: self.file.display().to_string(),
            why: error.message().to_owned(),
        })?;
        let known = content.token;
        Ok(Some(TokensRead { version, known }))
    }
}

impl TokensError {
    fn io(file: &Path, source: io::Error) -> Self {
        Self::Io {
            file: file.display().to_string(),
            source,
        }
    }
}

/// The secret of a token. It is shown on request only, never in a log.
#[derive(Clone, PartialEq, Eq)]
pub struct Token(String);

impl Token {
    /// Returns the secret: 64 hexadecimal digits.
    #[must_use]
    pub fn secret(&self) -> &str {
        &self.0
    }

    /// Parses a token that a station has created.
    ///
    /// # Errors
    ///
    /// [`TokensError::NoToken`] if it is not 64 hexadecimal digits.
    pub fn of_secret(secret: &str) -> Result<Self, TokensError> {
        let is_secret = secret.len() == 64 && secret.bytes().all(|byte| byte.is_ascii_hexdigit());
        let token = is_secret.then(|| Self(secret.to_ascii_lowercase()));
        token.ok_or(TokensError::NoToken)
    }

    /// Creates a token of 256 random bits.
    pub(crate) fn random() -> Result<Self, getrandom::Error> {
        let mut bits = [0; 32];
        getrandom::fill(&mut bits)?;
        Ok(Self(hex(&bits)))
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Token(secret)")
    }
}

/// The error returned when tokens cannot be read or changed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TokensError {
    /// The file cannot be read or written.
    #[error("{file}")]
    Io {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: io::Error,
    },
    /// The file has invalid contents.
    #[error("{file} is not a valid token file: {why}")]
    Content {
        /// The file.
        file: String,
        /// The problem.
        why: String,
    },
    /// Invalid name.
    #[error(
        "{0:?} is not a valid token name; names have 1 to 40 letters, digits, dots, dashes and spaces"
    )]
    Name(String),
    /// The name is in use.
    #[error("a token with the name {0:?} already exists; remove it first")]
    Taken(String),
    /// The token is already accepted under another name.
    #[error("this token is already accepted under the name {0:?}")]
    Known(String),
    /// Not a token.
    #[error("not a token; a token has 64 hexadecimal digits, as shown by `dobot token add`")]
    NoToken,
    /// Unknown name.
    #[error("there is no token with the name {0:?}")]
    Unknown(String),
    /// The system has no random numbers.
    #[error("the system has no random numbers")]
    Random(#[source] getrandom::Error),
}

/// The contents of the file.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Content {
    #[serde(default)]
    token: Vec<Known>,
}

/// The stored data of a token.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Known {
    name: String,
    role: Role,
    /// Whether it is shared by several people.
    #[serde(default, skip_serializing_if = "is_not")]
    shared: bool,
    sha256: String,
    /// The key that verifies proofs of the token; absent if an older program accepted the token.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    key: Option<String>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "required by serde")]
const fn is_not(value: &bool) -> bool {
    !*value
}

/// Identifies a version of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Version {
    written: SystemTime,
    len: u64,
    number: u64,
}

impl Version {
    fn of(file: &Path) -> io::Result<Option<Self>> {
        let found = match fs::metadata(file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            found => found?,
        };
        Ok(Some(Self {
            written: found.modified()?,
            len: found.len(),
            #[cfg(unix)]
            number: std::os::unix::fs::MetadataExt::ino(&found),
            #[cfg(not(unix))]
            number: 0,
        }))
    }
}

fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '_' | ' ');
    (1..=40).contains(&name.chars().count()) && name.chars().all(fits)
}

pub(crate) fn digest(secret: &str) -> [u8; 32] {
    Sha256::digest(secret.as_bytes()).into()
}

pub(crate) fn hex(bytes: &[u8]) -> String {
    data_encoding::HEXLOWER.encode(bytes)
}

/// Compares all bytes in constant time, so that the time reveals nothing.
fn same(one: &[u8], other: &[u8]) -> bool {
    let differences = one.iter().zip(other).fold(0, |all, (a, b)| all | (a ^ b));
    one.len() == other.len() && std::hint::black_box(differences) == 0
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn empty() -> (tempfile::TempDir, Tokens) {
        let folder = tempfile::tempdir().unwrap();
        let tokens = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        (folder, tokens)
    }

    /// Returns the holder of a token, by the current file.
    fn holder(tokens: &mut Tokens, secret: &str) -> Option<(String, Role)> {
        let read = tokens.source().read();
        tokens.apply(read);
        tokens.known(&digest(secret))
    }

    #[test]
    fn a_token_is_recognised_with_its_name_and_role_and_no_other_text_is() {
        let (_folder, mut tokens) = empty();
        let token = tokens.add(Role::Watch, "screen").unwrap();
        let screen = Some(("screen".to_owned(), Role::Watch));
        assert_eq!(holder(&mut tokens, token.secret()), screen);
        let mut other = token.secret().to_owned();
        other.replace_range(63.., if other.ends_with('0') { "1" } else { "0" });
        for wrong in ["", "screen", &other, &token.secret()[..63]] {
            assert_eq!(holder(&mut tokens, wrong), None, "{wrong}");
        }
    }

    #[test]
    fn neither_the_file_nor_the_debug_output_contains_the_secret() {
        let (folder, mut tokens) = empty();
        let token = tokens.add(Role::Admin, "me").unwrap();
        let local = tokens.make_local().unwrap();
        let file = fs::read_to_string(folder.path().join("tokens.toml")).unwrap();
        for text in [file, format!("{token:?} {local:?} {tokens:?}")] {
            assert!(!text.contains(token.secret()), "{text}");
            assert!(!text.contains(local.secret()), "{text}");
        }
    }

    #[test]
    fn a_digest_from_the_file_is_not_a_token() {
        let (_folder, mut tokens) = empty();
        let token = tokens.add(Role::Admin, "me").unwrap();
        assert_eq!(holder(&mut tokens, &hex(&digest(token.secret()))), None);
    }

    #[test]
    fn tokens_added_and_removed_by_another_program_take_effect_at_once() {
        let (folder, mut station) = empty();
        let mut program = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        let token = program.add(Role::Control, "plotter").unwrap();
        assert!(holder(&mut station, token.secret()).is_some());
        program.remove("plotter").unwrap();
        assert_eq!(holder(&mut station, token.secret()), None);
    }

    #[test]
    fn a_file_that_cannot_be_parsed_grants_no_access() {
        let (folder, mut station) = empty();
        let token = station.add(Role::Control, "plotter").unwrap();
        fs::write(folder.path().join("tokens.toml"), "token = 7").unwrap();
        assert_eq!(holder(&mut station, token.secret()), None);
        let error = Tokens::open(&folder.path().join("tokens.toml")).unwrap_err();
        assert!(
            error.to_string().contains("is not a valid token file"),
            "{error}"
        );
    }

    #[test]
    fn names_are_unique_and_readable() {
        let (_folder, mut tokens) = empty();
        tokens.add(Role::Watch, "one").unwrap();
        assert!(matches!(
            tokens.add(Role::Watch, "one"),
            Err(TokensError::Taken(_))
        ));
        assert!(matches!(
            tokens.add(Role::Watch, "a\nb"),
            Err(TokensError::Name(_))
        ));
        assert!(matches!(tokens.remove("two"), Err(TokensError::Unknown(_))));
    }

    #[test]
    fn two_tokens_are_never_the_same() {
        assert_ne!(Token::random().unwrap(), Token::random().unwrap());
    }
}
